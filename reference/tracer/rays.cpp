#include "reference/tracer/rays.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "pipeline/gpu/error.hpp"
#include "pipeline/scene/exact.hpp"
#include "reference/tracer/work.hpp"

#if CAUSTICS_EMBREE == 4
#include <embree4/rtcore.h>
#elif CAUSTICS_EMBREE == 3
#include <embree3/rtcore.h>
#endif

namespace caustics::tracer {

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

void intersect(RTCScene scene, RTCRayHit& query) {
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
#if CAUSTICS_EMBREE == 4
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.flags = RTC_RAY_QUERY_FLAG_INCOHERENT;
  rtcIntersect1(scene, &query, &arguments);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene, &context, &query);
#endif
}

bool occluded(RTCScene scene, RTCRay& query) {
#if CAUSTICS_EMBREE == 4
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  rtcOccluded1(scene, &query, &arguments);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(scene, &context, &query);
#endif
  return query.tfar < 0.0f;
}

// ---- Exact spheres: Embree asks for their box, and whether a ray of its own meets them.

const ExactSphere& sphere_in(void* user) { return *static_cast<const ExactSphere*>(user); }

void sphere_bounds(const RTCBoundsFunctionArguments* a) {
  const ExactSphere& s = sphere_in(a->geometryUserPtr);
  const double r = s.radius * (1.0 + 1e-5);
  RTCBounds& b = *a->bounds_o;
  b.lower_x = static_cast<float>(s.centre.x - r);
  b.lower_y = static_cast<float>(s.centre.y - r);
  b.lower_z = static_cast<float>(s.centre.z - r);
  b.upper_x = static_cast<float>(s.centre.x + r);
  b.upper_y = static_cast<float>(s.centre.y + r);
  b.upper_z = static_cast<float>(s.centre.z + r);
}

// The nearest meeting within the ray's range.
bool meets(const ExactSphere& sphere, const RTCRay& ray, float& distance) {
  const ExactSphere::Meetings m =
      sphere.meetings({ray.org_x, ray.org_y, ray.org_z}, {ray.dir_x, ray.dir_y, ray.dir_z});
  if (!m.real) return false;
  for (const double t : {m.first, m.second}) {
    distance = static_cast<float>(t);
    if (distance >= ray.tnear && distance <= ray.tfar) return true;
  }
  return false;
}

// A packet of one ray has the layout of the ray.
void intersect_sphere(const RTCIntersectFunctionNArguments* a) {
  RTCRayHit& query = *reinterpret_cast<RTCRayHit*>(a->rayhit);
  float distance = 0.0f;
  if (!a->valid[0] || !meets(sphere_in(a->geometryUserPtr), query.ray, distance)) return;
  query.ray.tfar = distance;
  query.hit.geomID = a->geomID;
  query.hit.primID = a->primID;
}

void occlude_by_sphere(const RTCOccludedFunctionNArguments* a) {
  RTCRay& ray = *reinterpret_cast<RTCRay*>(a->ray);
  float distance = 0.0f;
  if (a->valid[0] && meets(sphere_in(a->geometryUserPtr), ray, distance))
    ray.tfar = -std::numeric_limits<float>::infinity();
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
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                               mesh.vertices.data(), offsetof(Vertex, position), sizeof(Vertex),
                               mesh.vertices.size());
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                               mesh.indices.data(), 0, 3 * sizeof(std::uint32_t),
                               mesh.indices.size() / 3);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene, geometry, number);
    rtcReleaseGeometry(geometry);
  }

  // `sphere` must stay where it is.
  void add(const ExactSphere& sphere, unsigned number) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, 1);
    rtcSetGeometryUserData(geometry, const_cast<ExactSphere*>(&sphere));
    rtcSetGeometryBoundsFunction(geometry, sphere_bounds, nullptr);
    rtcSetGeometryIntersectFunction(geometry, intersect_sphere);
    rtcSetGeometryOccludedFunction(geometry, occlude_by_sphere);
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

RaySet::RaySet(const Scene& scene, const std::vector<int>& meshes, const std::vector<ExactSphere>& exact)
    : scene_(&scene), exact_(exact) {
  for (const int m : meshes)
    if (!scene.meshes[static_cast<std::size_t>(m)].indices.empty()) meshes_.push_back(m);
  if (meshes_.empty()) return;
  const PlainFloats plain;  // committing changes the mode, and is trusted to put it back only so far
  handles_ = std::make_unique<Handles>();
  for (std::size_t i = 0; i < meshes_.size(); ++i) {
    const auto number = static_cast<unsigned>(i);
    if (const ExactSphere* sphere = shape_of(meshes_[i])) handles_->add(*sphere, number);
    else handles_->add(scene.meshes[static_cast<std::size_t>(meshes_[i])], number);
  }
  handles_->commit();
}

std::optional<SurfaceHit> RaySet::nearest(const Ray& ray, double from, double to) const {
  if (!handles_) return std::nullopt;
  RTCRayHit query;
  fill(query.ray, ray, from, to);
  intersect(handles_->scene, query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return met_again(ray, meshes_[query.hit.geomID], static_cast<int>(query.hit.primID),
                   static_cast<double>(query.ray.tfar));
}

bool RaySet::blocked(const Ray& ray, double from, double to) const {
  if (!handles_) return false;
  RTCRay query;
  fill(query, ray, from, to);
  return occluded(handles_->scene, query);
}

#else

struct RaySet::Handles {};

bool has_ray_queries() { return false; }
const char* ray_queries_version() { return "none"; }

RaySet::RaySet(const Scene& scene, const std::vector<int>&, const std::vector<ExactSphere>&) : scene_(&scene) {
  throw Error(ExitCode::BackendUnavailable,
              "this build has no Embree, which finds the reference's rays; install libembree-dev and "
              "configure again");
}
std::optional<SurfaceHit> RaySet::nearest(const Ray&, double, double) const { return std::nullopt; }
bool RaySet::blocked(const Ray&, double, double) const { return false; }

#endif

RaySet::~RaySet() = default;
RaySet::RaySet(RaySet&&) noexcept = default;
RaySet& RaySet::operator=(RaySet&&) noexcept = default;

const ExactSphere* RaySet::shape_of(int mesh) const {
  const auto found =
      std::find_if(exact_.begin(), exact_.end(), [&](const ExactSphere& shape) { return shape.mesh == mesh; });
  return found == exact_.end() ? nullptr : &*found;
}

namespace {

SurfaceHit on_sphere(const ExactSphere& sphere, const Ray& ray, double distance) {
  const ExactSphere::Meetings m = sphere.meetings(ray.origin, ray.direction);
  SurfaceHit hit{.mesh = sphere.mesh};
  hit.front = std::fabs(m.first - distance) <= std::fabs(m.second - distance);
  hit.distance = hit.front ? m.first : m.second;
  hit.position = ray.at(hit.distance);
  hit.plane = hit.normal = exact::normalise(hit.position - sphere.centre, -ray.direction);
  return hit;
}

}  // namespace

// `distance` is Embree's, kept where the ray runs along the triangle.
SurfaceHit RaySet::met_again(const Ray& ray, int mesh, int triangle, double distance) const {
  if (const ExactSphere* sphere = shape_of(mesh)) return on_sphere(*sphere, ray, distance);
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
  hit.normal = exact::normalise(glm::dvec3(a.normal) * wa + glm::dvec3(b.normal) * wb + glm::dvec3(c.normal) * wc,
                                hit.plane);
  hit.uv = glm::dvec2(a.uv) * wa + glm::dvec2(b.uv) * wb + glm::dvec2(c.uv) * wc;
  return hit;
}

}  // namespace caustics::tracer
