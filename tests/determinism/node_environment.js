// Emscripten's programs don't see Node's environment variables by themselves; CAUSTICS_LANES is one.
Module['preRun'] = () => Object.assign(ENV, process.env);
