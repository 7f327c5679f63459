// The ray textures (ray_state.glsl) as attachments, and what the ledger is told.
OUTPUT(0, Vec4, ray_start)
OUTPUT(1, Vec4, ray_direction)
OUTPUT(2, Vec4, ray_flux)
OUTPUT(3, Vec4, ray_media)
OUTPUT(4, Vec4, ray_width)
OUTPUT(5, Vec4, ray_spread)
OUTPUT(6, Vec4, landing_fresnel)
OUTPUT(7, Vec4, landing_absorbed)
