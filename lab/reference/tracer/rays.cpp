#include "lab/reference/tracer/rays.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "lab/reference/tracer/optics.hpp"
#include "pipeline/gpu/error.hpp"
#include "pipeline/scene/exact.hpp"
#include "pipeline/scene/in_pieces.hpp"

#if CAUSTICS_EMBREE == 4
#include <embree4/rtcore.h>
#elif CAUSTICS_EMBREE == 3
#include <embree3/rtcore.h>
#endif

namespace caustics::tracer {

namespace {

// That a ray passes one behind the other, at most.
constexpr int kMostHoles = 256;

const Material& material_of(const Scene& scene, int mesh) {
  const int material = scene.meshes[static_cast<std::size_t>(mesh)].material;
  return scene.materials[static_cast<std::size_t>(material)];
}

}  // namespace

#if CAUSTICS_EMBREE

namespace {

void fill(RTCRay& to, const Ray& ray, double from, double until) {
  to.org_x = static_cast<float>(ray.origin.x);
  to.org_y = static_cast<float>(ray.origin.y);
  to.org_z = static_cast<float>(ray.origin.z);
  to.dir_x = static_cast<float>(ray.direction.x);
  to.dir_y = static_cast<float>(ray.direction.y);
  to.dir_z = static_cast<float>(ray.direction.z);
  to.tnear = static_cast<float>(std::max(from, 0.0));
  to.tfar = static_cast<float>(std::min(until, static_cast<double>(std::numeric_limits<float>::max())));
  to.time = 0.0f;
  to.mask = 0xffffffffu;
  to.id = 0;
  to.flags = 0;
}

#if CAUSTICS_EMBREE == 4
using Context = RTCRayQueryContext;
void start(Context& context) { rtcInitRayQueryContext(&context); }
#else
using Context = RTCIntersectContext;
void start(Context& context) { rtcInitIntersectContext(&context); }
#endif

// A query as exact shapes need it: Embree hands it through to their functions.
struct Query : Context {
  const Ray* ray;
  double from, to;
  ShapeMeeting met;  // of the shape that Embree names

  Query(const Ray& along, double lower, double upper) : ray(&along), from(std::max(lower, 0.0)), to(upper) {
    start(*this);
  }
};

void intersect(RTCScene scene, Query& query, RTCRayHit& hit) {
  hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  hit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
#if CAUSTICS_EMBREE == 4
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.flags = RTC_RAY_QUERY_FLAG_INCOHERENT;
  arguments.context = &query;
  rtcIntersect1(scene, &hit, &arguments);
#else
  rtcIntersect1(scene, &query, &hit);
#endif
}

bool occluded(RTCScene scene, Query& query, RTCRay& ray) {
#if CAUSTICS_EMBREE == 4
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.context = &query;
  rtcOccluded1(scene, &ray, &arguments);
#else
  rtcOccluded1(scene, &query, &ray);
#endif
  return ray.tfar < 0.0f;
}

// ---- Exact shapes: Embree asks for their box, and whether the ray meets them.

const ExactShape& shape_in(void* user) { return *static_cast<const ExactShape*>(user); }

// Wider than the shape by what single precision moves a ray by that starts a few scenes away.
void shape_bounds(const RTCBoundsFunctionArguments* a) {
  const Bounds box = shape_in(a->geometryUserPtr).bounds();
  const glm::dvec3 farthest = glm::max(glm::abs(box.lower), glm::abs(box.upper));
  const double margin = 1e-5 * (box.radius() + std::max({farthest.x, farthest.y, farthest.z}));
  RTCBounds& b = *a->bounds_o;
  b.lower_x = static_cast<float>(box.lower.x - margin);
  b.lower_y = static_cast<float>(box.lower.y - margin);
  b.lower_z = static_cast<float>(box.lower.z - margin);
  b.upper_x = static_cast<float>(box.upper.x + margin);
  b.upper_y = static_cast<float>(box.upper.y + margin);
  b.upper_z = static_cast<float>(box.upper.z + margin);
}

// A packet of one ray has the layout of the ray.
void intersect_shape(const RTCIntersectFunctionNArguments* a) {
  if (!a->valid[0]) return;
  RTCRayHit& hit = *reinterpret_cast<RTCRayHit*>(a->rayhit);
  Query& query = static_cast<Query&>(*a->context);
  const auto met = shape_in(a->geometryUserPtr).nearest(*query.ray, query.from, query.to);
  if (!met || static_cast<float>(met->distance) > hit.ray.tfar) return;
  query.met = *met;
  hit.ray.tfar = static_cast<float>(met->distance);
  hit.hit.geomID = a->geomID;
  hit.hit.primID = a->primID;
}

void occlude_by_shape(const RTCOccludedFunctionNArguments* a) {
  const Query& query = static_cast<const Query&>(*a->context);
  if (a->valid[0] && shape_in(a->geometryUserPtr).nearest(*query.ray, query.from, query.to))
    reinterpret_cast<RTCRay*>(a->ray)->tfar = -std::numeric_limits<float>::infinity();
}

// Embree reads the vertices where they are: three floats, with at least as many bytes behind the last as it
// wants to over-read.
static_assert(sizeof(Vertex) >= 16);

}  // namespace

struct RaySet::Handles {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;

  Handles() {
    device = rtcNewDevice(nullptr);
    if (!device)
      throw Error(ExitCode::BackendUnavailable, "Embree cannot start on this machine (error " +
                                                    std::to_string(rtcGetDeviceError(nullptr)) + ")");
    scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
  }
  ~Handles() {
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
  }
  Handles(const Handles&) = delete;
  Handles& operator=(const Handles&) = delete;

  void add(const Mesh& mesh, unsigned number) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_HIGH);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, mesh.vertices.data(),
                               offsetof(Vertex, position), sizeof(Vertex), mesh.vertices.size());
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh.indices.data(), 0,
                               3 * sizeof(std::uint32_t), mesh.indices.size() / 3);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene, geometry, number);
    rtcReleaseGeometry(geometry);
  }

  // `shape` must stay where it is.
  void add(const ExactShape& shape, unsigned number) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, 1);
    rtcSetGeometryUserData(geometry, const_cast<ExactShape*>(&shape));
    rtcSetGeometryBoundsFunction(geometry, shape_bounds, nullptr);
    rtcSetGeometryIntersectFunction(geometry, intersect_shape);
    rtcSetGeometryOccludedFunction(geometry, occlude_by_shape);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene, geometry, number);
    rtcReleaseGeometry(geometry);
  }

  void commit() {
    rtcCommitScene(scene);
    if (const RTCError error = rtcGetDeviceError(device); error != RTC_ERROR_NONE)
      throw Error(ExitCode::InternalError,
                  "Embree cannot build the scene (error " + std::to_string(error) + ")");
  }
};

bool has_ray_queries() { return true; }
const char* ray_queries_version() { return RTC_VERSION_STRING; }

RaySet::RaySet(const Scene& scene, const std::vector<int>& meshes, const std::vector<ExactShape>& exact,
               bool dressed)
    : scene_(&scene), exact_(exact), dressed_(dressed) {
  for (const int m : meshes)
    if (!scene.meshes[static_cast<std::size_t>(m)].indices.empty()) meshes_.push_back(m);
  for (const int m : meshes_) has_holes_ |= !scene.materials.empty() && may_have_holes(m);
  if (meshes_.empty()) return;
  const PlainFloats plain;  // committing changes the mode, and is trusted to put it back only so far
  handles_ = std::make_unique<Handles>();
  for (std::size_t i = 0; i < meshes_.size(); ++i) {
    const auto number = static_cast<unsigned>(i);
    if (const ExactShape* shape = shape_of(meshes_[i]))
      handles_->add(*shape, number);
    else
      handles_->add(scene.meshes[static_cast<std::size_t>(meshes_[i])], number);
  }
  handles_->commit();
}

std::optional<SurfaceHit> RaySet::nearest_surface(const Ray& ray, double from, double to) const {
  if (!handles_) return std::nullopt;
  Query query(ray, from, to);
  RTCRayHit hit;
  fill(hit.ray, ray, from, to);
  intersect(handles_->scene, query, hit);
  if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  const int mesh = meshes_[hit.hit.geomID];
  if (!shape_of(mesh))
    return met_again(ray, mesh, static_cast<int>(hit.hit.primID), static_cast<double>(hit.ray.tfar));
  return SurfaceHit{.mesh = mesh,
                    .distance = query.met.distance,
                    .position = ray.at(query.met.distance),
                    .plane = query.met.normal,
                    .normal = query.met.normal,
                    .front = query.met.front};
}

bool RaySet::blocked(const Ray& ray, double from, double to) const {
  if (!handles_) return false;
  if (has_holes_) return nearest(ray, from, to).has_value();
  Query query(ray, from, to);
  RTCRay probe;
  fill(probe, ray, from, to);
  return occluded(handles_->scene, query, probe);
}

#else

struct RaySet::Handles {};

bool has_ray_queries() { return false; }
const char* ray_queries_version() { return "none"; }

RaySet::RaySet(const Scene& scene, const std::vector<int>&, const std::vector<ExactShape>&, bool)
    : scene_(&scene) {
  throw Error(ExitCode::BackendUnavailable,
              "this build has no Embree, which finds the reference's rays; install libembree-dev and "
              "configure again");
}
std::optional<SurfaceHit> RaySet::nearest_surface(const Ray&, double, double) const { return std::nullopt; }
bool RaySet::blocked(const Ray&, double, double) const { return false; }

#endif

RaySet::~RaySet() = default;
RaySet::RaySet(RaySet&&) noexcept = default;
RaySet& RaySet::operator=(RaySet&&) noexcept = default;

bool RaySet::may_have_holes(int mesh) const {
  const AlphaMode mode = material_of(*scene_, mesh).alpha_mode;
  return mode == AlphaMode::Mask || (mode == AlphaMode::Blend && !dressed_);
}

bool RaySet::is_hole(const SurfaceHit& hit) const {
  return has_holes_ && hit.triangle >= 0 && may_have_holes(hit.mesh) &&
         is_cut_out(*scene_, material_of(*scene_, hit.mesh), hit.uv);
}

std::optional<SurfaceHit> RaySet::nearest(const Ray& ray, double from, double to) const {
  std::optional<SurfaceHit> hit = nearest_surface(ray, from, to);
  for (int passed = 0; hit && is_hole(*hit) && passed < kMostHoles; ++passed)
    hit = nearest_surface(ray, std::max(hit->distance, from) * (1.0 + 1e-6) + 1e-9, to);
  return hit;
}

const ExactShape* RaySet::shape_of(int mesh) const {
  const auto found =
      std::find_if(exact_.begin(), exact_.end(), [&](const ExactShape& shape) { return shape.mesh == mesh; });
  return found == exact_.end() ? nullptr : &*found;
}

// `distance` is Embree's, kept where the ray runs along the triangle.
SurfaceHit RaySet::met_again(const Ray& ray, int mesh, int triangle, double distance) const {
  const Mesh& m = scene_->meshes[static_cast<std::size_t>(mesh)];
  const auto vertex = [&](std::size_t corner) -> const Vertex& {
    return m.vertices[m.indices[3 * static_cast<std::size_t>(triangle) + corner]];
  };
  const Vertex &a = vertex(0), &b = vertex(1), &c = vertex(2);
  const glm::dvec3 corner(a.position);
  const glm::dvec3 ab = glm::dvec3(b.position) - corner, ac = glm::dvec3(c.position) - corner;
  const glm::dvec3 across = exact::cross(ab, ac);
  const double slope = exact::dot(across, ray.direction);
  SurfaceHit hit{.mesh = mesh, .triangle = triangle, .distance = distance};
  hit.plane = exact::normalise(across, glm::dvec3(a.normal));
  hit.front = slope <= 0.0;
  const double met = exact::dot(across, corner - ray.origin) / slope;
  if (std::isfinite(met)) hit.distance = met;
  hit.position = ray.at(hit.distance);
  // Weights of b and c, kept within the triangle: Embree's edges are rounded.
  const glm::dvec3 q = hit.position - corner;
  const double area = exact::dot(across, across);
  double wb = area > 0.0 ? exact::dot(exact::cross(q, ac), across) / area : 0.0;
  double wc = area > 0.0 ? exact::dot(exact::cross(ab, q), across) / area : 0.0;
  wb = std::clamp(wb, 0.0, 1.0);
  wc = std::clamp(wc, 0.0, 1.0 - wb);
  const double wa = 1.0 - wb - wc;
  hit.normal = exact::normalise(
      glm::dvec3(a.normal) * wa + glm::dvec3(b.normal) * wb + glm::dvec3(c.normal) * wc, hit.plane);
  hit.uv = glm::dvec2(a.uv) * wa + glm::dvec2(b.uv) * wb + glm::dvec2(c.uv) * wc;
  if (dressed_)
    hit.normal =
        leaned(*scene_, material_of(*scene_, mesh), hit.normal,
               glm::dvec4(a.tangent) * wa + glm::dvec4(b.tangent) * wb + glm::dvec4(c.tangent) * wc, hit.uv);
  return hit;
}

}  // namespace caustics::tracer
