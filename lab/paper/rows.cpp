#include "lab/paper/rows.hpp"

namespace caustics::paper {

std::vector<Row> paper_rows() {
  return {figure_row(),     sphere_row(),      formation_row(),  diagrams_row(), estimators_row(),
          receivers_row(),  water_row(),       grids_row(),      ring_row(),     dispersion_row(),
          dynamic_row(),    composition_row(), interfaces_row(), mirror_row(),   area_row(),
          maps_row(),       shadow_row(),      identity_row(),   weights_row(),  absorption_row(),
          times_row(),      gaps_row(),        gaussian_row(),   room_row(),     tessellation_row(),
          reflection_row(), visibility_row(),  haze_row(),       secant_row(),   tolerance_row(),
          offline_row(),    lights_row()};
}

}  // namespace caustics::paper
