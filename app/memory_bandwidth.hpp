// How fast this machine's memory is, for passes to be held against.
#pragma once

namespace caustics::app {

// Bytes a second of a[i] = b[i] + s * c[i] over arrays beyond the last-level cache (McCalpin's STREAM triad;
// two reads and a write are counted), the best of several rounds. Takes up to 1 GiB of memory and about a
// second.
double memory_bandwidth(int threads);

}  // namespace caustics::app
