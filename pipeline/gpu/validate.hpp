// Refuses a wrong definition or binding before any device sees it.
#pragma once
#include "pipeline/gpu/pass_run.hpp"

namespace caustics {

class Device;

// Throws Error (InternalError) with one line "pass 'name': what is wrong; what to do".
// Checks: a shader is set; reads and writes have the names of the TEXTURE and OUTPUT lines in the
// text, in their order; at least one attachment and at most 8 colours; no duplicate names; depth state only
// with a depth attachment; no blending on formats that cannot blend.
void validate(const PassDefinition& definition);

// Throws Error (InternalError) when the run does not fit the definition: number and formats of
// targets, equal sizes, a target that is also read, textures per draw, missing vertex attributes,
// `keep` of the wrong length, a uniform block of another size than the shader declares. The definition itself
// is not looked at again: whoever makes it validates it.
void validate(const PassRun& run, const Device& device);

}  // namespace caustics
