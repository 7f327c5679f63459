// How a grid vertex's light ended, STATUS_..., as w of the texture `landing` says it.
Bool has_status(Vec4 texel, int status) { return texel.w == float(status); }
