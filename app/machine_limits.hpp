// How fast this machine can be, for passes to be held against.
#pragma once

namespace caustics::app {

// Bytes a second of a[i] = b[i] + s * c[i] over arrays beyond the last-level cache (McCalpin's STREAM triad;
// two reads and a write are counted), the best of several rounds. Takes up to 1 GiB of memory and about a
// second.
double memory_bandwidth(int threads);

// Products and sums of floats a second, a * b + c rounded twice, in the widest vectors that this processor
// has, from registers alone; the best of several rounds.
double arithmetic_peak(int threads);

}  // namespace caustics::app
