#include "pipeline/renderer/stage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <vector>

#include "pipeline/effects/surface_role.hpp"
#include "pipeline/gpu/text.hpp"
#include "pipeline/renderer/camera_inside.hpp"
#include "pipeline/renderer/landed_light.hpp"
#include "pipeline/renderer/sun_side.hpp"
#include "pipeline/scene/defaults.hpp"
#include "pipeline/scene/exact.hpp"
#include "pipeline/scene/surroundings.hpp"
#include "pipeline/scene/triangle_tree.hpp"
#include "pipeline/settings/settings.hpp"
#include "pipeline/views/framing.hpp"

namespace caustics {

namespace {

// What is there catches enough of the light if it is this share of what a ground beside it would see landing.
constexpr double kCaught = 0.5;
// What of the landed light the camera shows: the brightest first until this share of it, and nothing that is
// less bright than this share of the light's own irradiance; within so many of the casters' radii.
constexpr double kShownLight = 0.9, kLeastBright = 0.2, kShownReach = 3.5;
constexpr double kCellsARadius = 8.0;   // in which brightness is told
constexpr double kLeastHeight = 0.035;  // the sine of 2 degrees, above which a sun lights a floor
constexpr double kMostRoll = 0.5;       // the sine by which a camera may lean to its side above a ground
constexpr Bearing kView{37.0f, 34.0f};
constexpr double kFov = 0.6;  // radians
// The camera goes down by these until it sees what shines, by this sine over its plane at least.
constexpr float kElevations[] = {24.0f, 16.0f, 10.0f, 6.0f, 3.0f};
constexpr double kSeenFromBelow = 0.06;

std::string lux_text(float lux) {
  return lux < 100.0f ? significant(static_cast<double>(lux), 2) : grouped(static_cast<std::uint64_t>(lux));
}

glm::dvec3 toward(const Bearing& bearing) {
  double sine, cosine, up, level;
  exact::sin_cos(static_cast<double>(bearing.azimuth) * exact::kPi / 180.0, sine, cosine);
  exact::sin_cos(static_cast<double>(bearing.elevation) * exact::kPi / 180.0, up, level);
  return {sine * level, up, cosine * level};
}

// The brightest of it, within `reach` of `centre`; told apart in cells of the size `cell`, metres.
std::vector<glm::dvec3> bright_part(const std::vector<Landed>& landed, const glm::dvec3& centre, double reach,
                                    double cell) {
  using Cell = std::array<long long, 3>;
  std::map<Cell, std::vector<const Landed*>> cells;
  double near = 0.0;
  for (const Landed& each : landed) {
    const glm::dvec3 p = each.position - centre;
    if (!(exact::length(p) < reach)) continue;
    const glm::dvec3 place = glm::floor(p / cell);
    cells[{static_cast<long long>(place.x), static_cast<long long>(place.y), static_cast<long long>(place.z)}]
        .push_back(&each);
    near += each.share;
  }
  std::vector<std::pair<double, Cell>> brightest;
  for (const auto& [place, inside] : cells) {
    double lit = 0.0;
    for (const Landed* each : inside) lit += each->area;
    if (lit > kLeastBright * cell * cell) brightest.emplace_back(-lit, place);
  }
  std::sort(brightest.begin(), brightest.end());
  std::vector<glm::dvec3> points;
  double shown = 0.0;
  for (const auto& [lit, place] : brightest) {
    if (shown >= kShownLight * near) break;
    for (const Landed* each : cells[place]) {
      points.push_back(each->position);
      shown += each->share;
    }
  }
  return points;
}

class Stage {
 public:
  Stage(Scene& scene, const Settings& settings, const Pilot& pilot)
      : scene_(scene),
        settings_(settings),
        pilot_(pilot),
        around_(surroundings_of(scene)),
        subject_(around_.thing) {
    if (subject_.empty()) {
      subject_.add(glm::dvec3(-0.5));
      subject_.add(glm::dvec3(0.5));
    }
  }

  Completed complete() {
    const auto loaded = static_cast<std::ptrdiff_t>(scene_.notes.size());
    completed_ = {.lights = scene_.lights.empty() || settings_.sun,
                  .cameras = scene_.cameras.empty() || settings_.view};
    const std::optional<double> height = ground_height();
    const bool tries = settings_.ground.wish == Ground::Wish::Auto && around_.has_floor;
    if (height) add_ground(scene_, subject_, *height);
    LandedLight light(scene_, settings_, pilot_);
    if (completed_.lights) place_sun(light);
    if ((height && tries) || completed_.cameras) landed_ = light.find();
    if (height) keep_ground(*height, tries);
    if (completed_.cameras) place_camera();
    if (add_sky(scene_))
      say("the light of a studio",
          "No environment image was given: a neutral studio lights the scene with 30 % of what its lights "
          "give.");
    scene_.environment.reach = static_cast<float>(around_.thing.empty() ? 0.0 : subject_.radius());
    note_low_sun();
    // Said before what the loader noted, of which there may be much.
    std::rotate(scene_.notes.begin(), scene_.notes.begin() + loaded, scene_.notes.end());
    return completed_;
  }

 private:
  void say(const std::string& what, const std::string& why) {
    completed_.added.push_back(what);
    scene_.notes.push_back(why);
  }

  // Light that comes level or from below reaches no floor, and neither do its caustics.
  void note_low_sun() {
    double highest = -1.0;
    for (const Light& light : scene_.lights)
      highest = std::max(highest, light.type == LightType::Directional ? -light.direction.y : 1.0);
    if (scene_.lights.empty() || highest >= kLeastHeight) return;
    scene_.notes.push_back(std::string("The sun ") +
                           (highest > -kLeastHeight ? "stands on the horizon" : "shines from below") +
                           ": it lights no floor and throws no caustics there; --sun 217,60 raises it.");
  }

  // From the scene to where the camera stands, along the ground: a unit vector.
  glm::dvec3 camera_side() const {
    glm::dvec3 side = toward(settings_.view.value_or(kView));
    if (!completed_.cameras) {
      // A camera that looks straight down stands where the lower edge of its picture is.
      const Camera& camera = scene_.cameras.front();
      side = std::fabs(camera.forward.y) > 0.99 ? -camera.up : -camera.forward;
    }
    return exact::normalise({side.x, 0.0, side.z}, {0.6, 0.0, 0.8});
  }

  // Unit, from the scene.
  glm::dvec3 toward_camera() const {
    return completed_.cameras ? toward(settings_.view.value_or(kView)) : -scene_.cameras.front().forward;
  }

  void place_sun(LandedLight& light) {
    const float lux = settings_.sun && settings_.sun->lux ? *settings_.sun->lux : sun_lux(scene_.environment);
    if (settings_.sun) return set_sun(scene_, -toward(settings_.sun->stands), lux);
    set_sun(scene_, {0.0, -1.0, 0.0}, lux);
    const SunSide side = sun_side(scene_, light, toward_camera(), camera_side());
    set_sun(scene_, side.direction, lux);
    const std::string strong = "a sun of " + lux_text(lux) + " lux";
    say(strong,
        "The scene has no light: " + strong + ", " + side.where + " it as the camera sees it, was added.");
  }

  // Where the ground is to be tried; none where it is not wanted.
  std::optional<double> ground_height() const {
    if (settings_.ground.wish == Ground::Wish::Off) return {};
    if (settings_.ground.wish == Ground::Wish::At)
      return static_cast<double>(settings_.ground.height) - scene_.origin.y;
    if (settings_.ground.wish == Ground::Wish::Auto && scene_.meshes.empty()) return {};
    const Bounds all = bounds_of(scene_);
    // A little below, so that a camera's depth range tells a flat underside from the ground.
    const double height = (all.empty() ? subject_ : all).lower.y - 1e-3 * widest(subject_);
    // It would hide the scene from a camera below, and stand upright before one that is rolled.
    const auto is_strange = [&](const Camera& camera) {
      return !(camera.position.y > height) || std::fabs(camera.right.y) > kMostRoll;
    };
    const bool unfit = settings_.ground.wish == Ground::Wish::Auto &&
                       std::any_of(scene_.cameras.begin(), scene_.cameras.end(), is_strange);
    if (unfit && !completed_.cameras) return {};
    return height;
  }

  // Unless the scene has a floor, which catches the casters' light.
  void keep_ground(double height, bool tries) {
    const double above = height + 1e-5 * widest(subject_);
    double all = 0.0, caught = 0.0;
    for (const Landed& each : landed_) {
      all += each.share;
      if (each.position.y > above) caught += each.share;
    }
    if (tries && caught >= kCaught * all) return remove_ground(above);
    std::string why = "no floor reaches well beyond what is shown";
    if (settings_.ground.wish != Ground::Wish::Auto)
      why = "as asked for";
    else if (tries)
      why = "the scene itself catches " + rounded_text(100.0 * caught / all, 2) +
            " % of the light that lands through its glass and off its mirrors";
    say("a grey ground", "A grey ground was added: " + why + ".");
  }

  void remove_ground(double above) {
    scene_.meshes.pop_back();
    scene_.materials.pop_back();
    landed_.erase(std::remove_if(landed_.begin(), landed_.end(),
                                 [&](const Landed& each) { return !(each.position.y > above); }),
                  landed_.end());
  }

  void place_camera() {
    const Bounds casters = subject_of(scene_);
    const double radius = std::max(casters.radius(), 1e-9);
    std::vector<glm::dvec3> points =
        bright_part(landed_, casters.centre(), kShownReach * radius, radius / kCellsARadius);
    std::vector<glm::dvec3> shown;
    for (std::size_t mesh = 0; mesh < around_.around.size(); ++mesh)
      if (!around_.around[mesh]) add_points(scene_.meshes[mesh], shown);
    for (const Light& light : scene_.lights)
      add_shadow(light, shown, kShownReach * subject_.radius(), points);
    points.insert(points.end(), shown.begin(), shown.end());
    add_lit(points);
    const double fov = settings_.fov ? static_cast<double>(*settings_.fov) * exact::kPi / 180.0 : kFov;
    const auto framed = [&](const Bearing& from) {
      return framing_camera(points, -toward(from), fov,
                            static_cast<double>(settings_.width) / settings_.height, 0.1 * widest(subject_));
    };
    const Bearing from = settings_.view.value_or(kView);
    Camera camera = framed(from);
    for (const float elevation : kElevations) {
      if (settings_.view || shows_what_shines(camera)) break;
      const Camera lower = framed({from.azimuth, elevation});
      if (shows_what_shines(lower)) camera = lower;
    }
    const bool inside = come_inside(camera, scene_, around_.around, subject_, settings_);
    camera.name = settings_.view ? "view " + text_of(settings_.view) : "three-quarter view (added)";
    if (!settings_.view)
      say(kAddedCamera, std::string("The scene has no camera: a three-quarter view from above was added") +
                            (inside ? ", before the wall that would hide the scene." : "."));
    scene_.cameras = {camera};
  }

  // Where meshes alone light the scene: is the camera on the side to which one of them shines? From behind a
  // lamp of one side is not seen at all.
  bool shows_what_shines(const Camera& camera) const {
    return std::any_of(scene_.lights.begin(), scene_.lights.end(), [&](const Light& light) {
      const glm::dvec3 way = camera.position - light.position;
      return light.emitter < 0 || !light.lambertian ||
             exact::dot(way, light.direction) > kSeenFromBelow * exact::length(way);
    });
  }

  // A mesh that shines is shown with what it lights: the surface before it, as wide as it is far away.
  void add_lit(std::vector<glm::dvec3>& points) const {
    for (const Light& light : scene_.lights) {
      if (light.emitter < 0) continue;
      std::vector<int> others;
      for (int m = 0; m < static_cast<int>(scene_.meshes.size()); ++m)
        if (m != light.emitter) others.push_back(m);
      const auto lit = TriangleTree(scene_, others).nearest(light.position, light.direction);
      if (!lit) continue;
      const glm::dvec3 middle = light.position + light.direction * lit->distance;
      for (const double x : {-0.5, 0.5})
        for (const double z : {-0.5, 0.5})
          points.push_back(middle + glm::dvec3(x * lit->distance, 0.0, z * lit->distance));
    }
  }

  // That a sun throws onto an added ground, as far as caustics are shown.
  void add_shadow(const Light& light, const std::vector<glm::dvec3>& shown, double reach,
                  std::vector<glm::dvec3>& points) const {
    const auto ground = std::find_if(scene_.meshes.begin(), scene_.meshes.end(),
                                     [](const Mesh& mesh) { return mesh.name == kGroundName; });
    const double fall = -light.direction.y;
    if (light.type != LightType::Directional || ground == scene_.meshes.end() || !(fall > 0.1)) return;
    for (const glm::dvec3& p : shown) {
      const double height = p.y - static_cast<double>(ground->upper.y);
      const glm::dvec3 q = p + light.direction * (std::max(height, 0.0) / fall);
      if (exact::length(q - subject_.centre()) < reach) points.push_back(q);
    }
  }

  // Its vertices; and where it is said to reach farther, as what moves does, its outline, or else the corners
  // of its bounds.
  static void add_points(const Mesh& mesh, std::vector<glm::dvec3>& points) {
    glm::vec3 lower(std::numeric_limits<float>::infinity()), upper = -lower;
    for (const Vertex& vertex : mesh.vertices) {
      points.emplace_back(vertex.position);
      lower = glm::min(lower, vertex.position);
      upper = glm::max(upper, vertex.position);
    }
    for (const glm::vec3& point : mesh.outline) points.emplace_back(point);
    if (!mesh.outline.empty() || (lower == mesh.lower && upper == mesh.upper)) return;
    for (int corner = 0; corner < 8; ++corner)
      points.emplace_back((corner & 1) ? mesh.upper.x : mesh.lower.x,
                          (corner & 2) ? mesh.upper.y : mesh.lower.y,
                          (corner & 4) ? mesh.upper.z : mesh.lower.z);
  }

  Scene& scene_;
  const Settings& settings_;
  const Pilot pilot_;
  Surroundings around_;
  Bounds subject_;  // what is shown
  std::vector<Landed> landed_;
  Completed completed_;
};

}  // namespace

Completed complete_scene(Scene& scene, const Settings& settings, const Pilot& pilot) {
  return Stage(scene, settings, pilot).complete();
}

}  // namespace caustics
