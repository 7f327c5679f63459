#include "pipeline/renderer/run_plan.hpp"

#include "pipeline/effects/dim_lights.hpp"
#include "pipeline/gpu/device.hpp"
#include "pipeline/gpu/interrupt.hpp"
#include "pipeline/scene/cube_view.hpp"
#include "pipeline/settings/settings.hpp"
#include "pipeline/views/sub_pixel.hpp"

namespace caustics {

FrameTargets::FrameTargets(const FramePlan& plan, Device& device) : device_(device) {
  for (const TextureMemory& each : plan.memory) {
    stop_if_interrupted();  // software renderers of OpenGL fill what they make with zeros
    OwnedTexture texture(device, device.create_texture(each.format, each.width, each.height));
    memory_.push_back(std::move(texture));
  }
  for (const PlannedTexture& texture : plan.textures)
    places_.push_back(texture.external ? memory_.size() : static_cast<std::size_t>(texture.memory));
}

void FrameTargets::replace(int index, const Image& image) {
  memory_[place_of(index)] = OwnedTexture(device_, device_.upload(image));
}

namespace {

class PassRunner {
 public:
  PassRunner(const FramePlan& plan, const Registry& registry, const SceneOnDevice& scene,
             const FrameTargets& targets, const FrameInputs& inputs)
      : plan_(plan),
        registry_(registry),
        scene_(scene),
        targets_(targets),
        inputs_(inputs),
        settings_(*inputs.settings, *inputs.effects),
        cameras_{inputs.camera} {
    const Settings& settings = *inputs.settings;
    for (const SubPixel& by : sub_pixels(samples_a_pixel(settings)))
      cameras_.push_back(shifted(inputs.camera, by, settings.width, settings.height));
    const bool sees = std::any_of(plan.passes.begin(), plan.passes.end(), [](const PlannedPass& pass) {
      return is_of_casters_in_view(*pass.drawn_for);
    });
    if (sees) eye_media_ = scene.tables().bodies_around(inputs.camera.origin);
  }

  PassRun prepare(const PlannedPass& planned) const {
    const Pass& pass = registry_[static_cast<std::size_t>(planned.pass)];
    PassRun run{.definition = planned.definition.get(), .keep = planned.keep};
    for (const int texture : planned.writes)
      run.colors.push_back(texture == PlannedPass::kNothing ? TextureId::None : targets_[texture]);
    if (planned.depth >= 0) run.depth = targets_[planned.depth];
    run.counts_into = static_cast<OcclusionQuery>(planned.counts_into);
    run.only_if = static_cast<OcclusionQuery>(planned.only_if);
    PassContext context = frame_context(planned);
    switch (pass.draws) {
      case DrawSet::FullScreen:
        run.draws.push_back(draw(pass, planned, context, MeshId::None, 3));
        break;
      case DrawSet::GridVertices:
        run.draws.push_back(
            draw(pass, planned, context, MeshId::None, context.settings->grid * context.settings->grid));
        break;
      case DrawSet::GridColumns:
        run.draws.push_back(draw(pass, planned, context, MeshId::None, context.settings->grid));
        break;
      case DrawSet::GridCells:
        if (const int cells = context.settings->grid - 1; cells > 0)
          run.draws.push_back(draw(pass, planned, context, MeshId::None, cells * cells));
        break;
      case DrawSet::Beams: {
        const int beams = beams_a_side(*context.settings);
        run.draws.push_back(draw(pass, planned, context, MeshId::None, 6 * beams * beams));
        break;
      }
      case DrawSet::Receivers:
      case DrawSet::Casters:
      case DrawSet::Shadowing:
      case DrawSet::SolidCasters:
      case DrawSet::LightTinters:
        add_mesh_draws(pass, planned, context, run);
        break;
    }
    return run;
  }

 private:
  PassContext frame_context(const PlannedPass& planned) const {
    PassContext context{.scene = &scene_.scene(),
                        .settings = &settings_[planned.light],
                        .effects = inputs_.effects,
                        .camera = &cameras_[static_cast<std::size_t>(planned.sample)],
                        .sample = planned.sample,
                        .width = planned.width,
                        .height = planned.height,
                        .exposure = inputs_.exposure.factor,
                        .contrast = inputs_.exposure.contrast,
                        .drawn_for = planned.drawn_for};
    context.first_receiver = scene_.tables().first_receiver();
    context.first_uv = scene_.tables().first_uv();
    context.touch = scene_.tables().touch();
    context.eye_media = eye_media_;
    if (planned.light >= 0) {
      const auto light = static_cast<std::size_t>(planned.light);
      context.light = &scene_.scene().lights[light];
      context.of_light = &inputs_.effects->lights[light];
      context.views = &(*inputs_.views)[light];
      if (context.of_light->size_is_drawn)
        context.first_point = scene_.tables().first_point(context.light->source);
    }
    if (planned.water >= 0) {
      context.water = &scene_.scene().waters[static_cast<std::size_t>(planned.water)];
      context.water_step = context.water->last_step;
    }
    if (planned.branch >= 0)
      context.branch = &inputs_.effects->branches[static_cast<std::size_t>(planned.branch)];
    return context;
  }

  void add_mesh_draws(const Pass& pass, const PlannedPass& planned, PassContext& context,
                      PassRun& run) const {
    const Scene& scene = scene_.scene();
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
      if (!draws_mesh(pass.draws, *planned.drawn_for, *inputs_.effects, i, context.of_light)) continue;
      if (context.light && context.light->emitter == static_cast<int>(i)) continue;
      context.mesh = &scene.meshes[i];
      context.mesh_index = static_cast<int>(i);
      context.material = &scene.materials[static_cast<std::size_t>(context.mesh->material)];
      context.material_row = scene_.tables().material_row(context.mesh_index);
      context.first_triangle = scene_.tables().first_triangle(context.mesh_index);
      add_mesh_draw(pass, planned, context, run);
    }
  }

  // Once, or once for each face of a cube that may see it.
  void add_mesh_draw(const Pass& pass, const PlannedPass& planned, PassContext& context, PassRun& run) const {
    const MeshId mesh = scene_.mesh(context.mesh_index);
    const LightViews* views = context.views;
    const bool light_all_around = views && views->caster.cube;
    if (!light_all_around && !pass.all_around) {
      run.draws.push_back(draw(pass, planned, context, mesh, 0));
      return;
    }
    LightViews faced;
    for (int face = 0; face < 6; ++face) {
      context.face = face;
      if (light_all_around) {
        faced = facing(*views, face);
        context.views = &faced;
      }
      const bool seen = light_all_around ? face_sees(faced.caster, face, *context.mesh) ||
                                               face_sees(faced.caustic, face, *context.mesh)
                                         : face_sees(pass.all_around(context), face, *context.mesh);
      if (seen) run.draws.push_back(draw(pass, planned, context, mesh, 0));
    }
    context.views = views;
  }

  // The views of a light that sees all around, as one of their faces is drawn.
  static LightViews facing(LightViews views, int face) {
    for (View LightViews::*view : {&LightViews::caster, &LightViews::receiver, &LightViews::caustic,
                                   &LightViews::shadow, &LightViews::panes})
      (views.*view).face = face;
    return views;
  }

  Draw draw(const Pass& pass, const PlannedPass& planned, const PassContext& context, MeshId mesh,
            int vertex_count) const {
    Draw result{.mesh = mesh, .vertex_count = vertex_count, .uniforms = pass.uniforms(context)};
    for (std::size_t i = 0; i < planned.reads.size(); ++i)
      result.textures.push_back(bound(planned.reads[i], planned.definition->reads[i].name, context.material));
    return result;
  }

  TextureId bound(int texture, const std::string& name, const Material* material) const {
    if (texture == PlannedPass::kNothing) return TextureId::None;
    if (texture == PlannedPass::kMaterial) return material_texture(name, *material);
    const PlannedTexture& planned = plan_.textures[static_cast<std::size_t>(texture)];
    return planned.external ? scene_.external(planned.name) : targets_[texture];
  }

  TextureId material_texture(const std::string& name, const Material& material) const {
    struct Use {
      std::string_view name, levels;
      TextureUse Material::*use;
    };
    static constexpr Use kUses[] = {
        {"base_color", "base_color_levels", &Material::base_color_texture},
        {"normal_texture", "normal_levels", &Material::normal_texture},
        {"transmission_texture", "", &Material::transmission_texture},
        {"emissive", "emissive_levels", &Material::emissive_texture},
        {"metallic_roughness", "metallic_roughness_levels", &Material::metallic_roughness_texture},
        {"occlusion", "occlusion_levels", &Material::occlusion_texture}};
    for (const Use& use : kUses) {
      if (name == use.name) return scene_.image((material.*use.use).image);
      if (name == use.levels) return scene_.coarser((material.*use.use).image);
    }
    throw Error(ExitCode::InternalError, "no material has a texture '" + name + "'");
  }

  const FramePlan& plan_;
  const Registry& registry_;
  const SceneOnDevice& scene_;
  const FrameTargets& targets_;
  const FrameInputs& inputs_;
  const LightSettings settings_;
  glm::vec4 eye_media_{0.0f};
  std::vector<View> cameras_;  // of the pixels' middles, then by sample
};

}  // namespace

PassRun prepare_pass(const FramePlan& plan, const PlannedPass& pass, const Registry& registry,
                     const SceneOnDevice& scene, const FrameTargets& targets, const FrameInputs& inputs) {
  return PassRunner(plan, registry, scene, targets, inputs).prepare(pass);
}

std::vector<PassReport> run_plan(const FramePlan& plan, const Registry& registry, const SceneOnDevice& scene,
                                 const FrameTargets& targets, const FrameInputs& inputs,
                                 const AfterPass& after) {
  const PassRunner runner(plan, registry, scene, targets, inputs);
  std::vector<PassReport> reports;
  for (const PlannedPass& planned : plan.passes) {
    stop_if_interrupted();
    const PassResult result = scene.device().run(runner.prepare(planned));
    reports.push_back({planned.label, result});
    if (after && !after(planned, result, reports.size(), plan.passes.size()))
      throw Error(ExitCode::Interrupted, "interrupted after pass '" + planned.label + "'");
  }
  return reports;
}

}  // namespace caustics
