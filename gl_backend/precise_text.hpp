// Marks the float operations of a GLSL text `precise`, so that no driver contracts a * b + c or reorders
// sums.
//
// `precise` reaches only those expressions of its own function whose result ends in a variable that bears it
// (GLSL 4.60, section 4.9): not the functions that are called there, and no conditions. So every variable
// must bear it, and every result must pass through a variable. Authors of shaders write none of this: the
// text is rewritten on its way to the driver. Macros cannot do it: one for `Float` would also reach
// constructors, `Float(1.0f)`, and return types, where Mesa refuses qualifiers, and `return` and `if` are
// keywords.
#pragma once
#include <string>
#include <string_view>

namespace caustics::gl {

// The text with
// - `precise` before the type of each local variable and parameter,
// - `return e;` of a function of type T as `{ precise T returned = e; return returned; }`,
// - conditions of if, for and while that calculate assigned to the prelude's `exact_condition`.
// Two places stay unmarked, and tests/architecture/shaders.py refuses them: what a statement hands to a void
// function, `f(a + b);`, and what a component is taken from on the spot, `f(a + b).x`. Comments, preprocessor
// lines and the numbers of lines stay as they are. What is not GLSL is copied as well as can be.
std::string precise_text(std::string_view text);

}  // namespace caustics::gl
