// Closed forms: what some scenes look like exactly, to test renderings against. Double precision,
// and free to use the standard library's functions, for nothing here feeds a pass.
//
// Lengths in metres, angles in radians, absorption per metre. Irradiance is relative to E, the
// irradiance of a plane across the incoming light ("E / E_perp"). `n` is the refractive index of
// the body relative to what surrounds it; n < 1 is a bubble.
#pragma once
#include <glm/glm.hpp>
#include <limits>
#include <optional>
#include <vector>

namespace caustics {

// ---- One interface (Snell's law, Fresnel's equations)

// Angle of refraction; none in total internal reflection.
std::optional<double> refraction_angle(double incidence, double n1, double n2);
// Incidence inside the denser medium beyond which all light is reflected, n > 1 its relative index.
double critical_angle(double n);
// Incidence from outside at which light polarised in the plane of incidence is not reflected.
double brewster_angle(double n);

struct Reflectance {
  double s = 1.0;  // polarised across the plane of incidence
  double p = 1.0;  // polarised in it
  double mean() const { return 0.5 * (s + p); }
};
// Fresnel's equations for light going from n1 to n2; (1, 1) in total internal reflection.
Reflectance fresnel(double cos_incidence, double n1, double n2);

// Direction behind the interface, unit; none in total internal reflection. `normal` points to where
// the light comes from; eta = n1 / n2. Snell's law as t = eta d - mu N in a form that cancels
// neither at eta = 1 nor at grazing incidence.
std::optional<glm::dvec3> refract_direction(const glm::dvec3& direction, const glm::dvec3& normal,
                                            double eta);

// Beer and Lambert: what is left after `distance` metres at `absorption` per metre.
double beer_lambert(double absorption, double distance);
// Absorption per metre of glTF's KHR_materials_volume: attenuationColor is left after
// attenuationDistance.
double absorption_of(double attenuation_color, double attenuation_distance);

// ---- Pictures

// A square of floor cut into pixels, and what falls on them.
struct FloorSquare {
  glm::dvec2 lower{-1.0};  // corner, metres
  double side = 2.0;       // metres
  int pixels = 1;          // a side
};
struct FloorIrradiance {
  std::vector<double> values;  // mean of E / E_perp over each pixel, rows from the lower corner on
  double flux = 0.0;           // through the whole square: square metres times E_perp
};

// ---- Sphere under parallel light, seen on a plane across the light
// Two refractions at incidence alpha = asin(b / R), inside beta = asin(b / (n R)), deviate the ray
// of impact parameter b by delta = 2 (alpha - beta) (Snell's law and the isosceles triangle of the
// chord).

enum class InterfaceLoss {
  None,         // all light passes
  Unpolarised,  // mean of s and p at each interface, as renderers do
  Polarised     // s and p kept apart from entry to exit, as light does
};

struct GlassSphere {
  double radius = 1.0;
  double index = 1.5;
  double distance = 2.0;    // from the centre to the plane, > radius
  double absorption = 0.0;  // per metre
  InterfaceLoss loss = InterfaceLoss::Unpolarised;

  // All for an impact parameter 0 <= b < radius, below n * radius for n < 1.
  double deviation(double b) const;
  // Where the ray meets the plane, along the axis' radius: negative beyond the axis. The deviation
  // must be below 90 degrees.
  double landing(double b) const;
  double landing_derivative(double b) const;  // d landing / d b
  double chord(double b) const;               // path inside
  double transmittance(double b) const;       // of both interfaces and the chord
  // Where the landing is if light bends at the entry only (the single-surface option).
  double single_surface_landing(double b) const;

  // From the centre to where the ray crosses the axis; in the limits b -> 0 and b -> radius.
  double axis_crossing(double b) const;
  double paraxial_focus() const;
  double marginal_focus() const;  // n > 1

  // Largest impact parameter that reaches the plane: below it, deviation < 90 degrees and no total
  // internal reflection.
  double largest_impact() const;
  // Irradiance at a distance r > 0 from the axis, summed over every b that lands there; infinite on
  // a fold.
  double irradiance(double r) const;
  // Share of the light onto the sphere that passes both interfaces, wherever it goes.
  double transmitted_share() const;
};

// Mean irradiance on each pixel, the axis at (0, 0). Refracted light only: outside the shadow (r >
// R) the direct light adds 1. By counting: the rays of thin rings of impact parameters are booked
// to thin rings of the plane, whose areas inside each pixel are exact; so folds and the spike on
// the axis are as right as everything else.
FloorIrradiance irradiance_average(const GlassSphere& sphere, const FloorSquare& floor,
                                   int rings_per_pixel = 16, int ray_rings = 400'000);
// Mean irradiance of the annulus inner <= r <= outer on the plane, by the same counting.
double annulus_average(const GlassSphere& sphere, double inner, double outer, int ray_rings = 400'000);
// Mean of exp(-absorption * chord) over the sphere's disc, without loss at the interfaces.
double mean_absorption(const GlassSphere& sphere);

// Area of the disc round (0, 0) inside the box.
double disc_in_box(double radius, const glm::dvec2& lower, const glm::dvec2& upper);

// ---- Water z = depth + a cos(k x) over a floor at z = 0 under vertical light

struct WaterWave {
  double amplitude = 0.0;    // a
  double wave_number = 1.0;  // k, radians per metre
  double index = 1.33;
  double depth = 1.0;  // of the floor below the mean surface
  bool fresnel = true;

  double height(double x) const;
  double incidence(double x) const;  // signed: the slope's angle
  double landing(double x) const;
  double landing_derivative(double x) const;
  double transmittance(double x) const;
  // Of the floor where the ray through x lands, counting this ray alone; before the first focus it
  // is all.
  double irradiance(double x) const;
  // Depth below a crest at which light is first focused: n / ((n - 1) a k^2).
  double first_focus() const;
};

// Mean irradiance of each of `pixels` strips that divide the floor from `lower` to `upper`; the
// sheet of water reaches from -half_width to half_width. By counting, so valid behind foci, too.
std::vector<double> irradiance_average(const WaterWave& wave, double lower, double upper, int pixels,
                                       double half_width = std::numeric_limits<double>::infinity());

// ---- Flat surfaces

// Sideways displacement of the ray, and how much nearer to the slab it meets a floor parallel to
// it.
double slab_offset(double incidence, double n, double thickness);
double slab_floor_shift(double incidence, double n, double thickness);
// One pass through both interfaces and the glass: mean of s and p at each interface.
double slab_transmittance(double incidence, double n, double thickness, double absorption = 0.0);
// All internal reflections added up, without absorption: mean of (1 - R) / (1 + R) over s and p.
double slab_transmittance_all_bounces(double incidence, double n);

// A point light of intensity 1 at `height` over flat water of `depth`; theta from the vertical.
struct LightOverWater {
  double height = 1.0, depth = 1.0, index = 1.33;
  double landing(double theta) const;     // from the axis, on the floor
  double irradiance(double theta) const;  // at that place: candela per square metre
};

// ---- Prism of apex angle A, in the plane across its edges

// Angle by which the ray is turned; none where it does not leave through the second face.
std::optional<double> prism_deviation(double apex, double n, double incidence);
double prism_least_deviation(double apex, double n);
double prism_least_incidence(double apex,
                             double n);  // below it, total reflection at the second face

// Index at a wavelength in nanometres: the Cauchy formula of glTF's KHR_materials_dispersion, with
// dispersion = 20 / Abbe number, and n the index at 587.6 nm.
double dispersive_index(double n, double dispersion, double wavelength);
// Sellmeier's formula with the maker's numbers for the glass BK7; wavelength in micrometres.
double bk7_index(double wavelength);

// ---- Mirrors: a vertical cylinder of radius R lit from inside, light along +x in plan view.
// Reflected at R (cos t, sin t) it runs along -(cos 2t, sin 2t); the envelope is a nephroid.

double ring_axis_crossing(double radius, double t);  // x where that ray crosses the x axis
glm::dvec2 ring_envelope(double radius, double t);   // cusp at (radius / 2, 0)
// Irradiance of the floor by this ray relative to the direct light's on the floor: s is the way in
// plan view from the wall, that is height of reflection times cot(elevation).
double ring_irradiance(double radius, double t, double s, double reflectance = 1.0);

// ---- A lens without aberration: flat entry, hyperboloid exit with its vertex at z = 0, light
// along +z.

struct HyperbolicLens {
  double index = 1.5;
  double focus = 1.0;                            // distance of the focus behind the vertex
  double surface(double r) const;                // z <= 0 of the exit surface at r from the axis
  double slope(double r) const;                  // dz / dr of it
  double landing(double r, double plane) const;  // signed, on the plane z = plane
  // Of that place, without loss at the interfaces; plane != focus.
  double irradiance(double r, double plane) const;
};

}  // namespace caustics
