#include "app/parity_dump.hpp"

#include "app/json.hpp"
#include "app/output/dump.hpp"
#include "app/output/image_file.hpp"
#include "app/output/stats.hpp"
#include "app/shell/atomic_file.hpp"

namespace caustics::app {

namespace {

Image mask_of(const Image& a, const Image& b) {
  Image mask(Format::R32F, a.width(), a.height());
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
      for (int c = 0; c < a.channels(); ++c)
        if (!same_value(a.at(x, y, c), b.at(x, y, c))) mask.at(x, y, 0) = 1.0f;
  return mask;
}

}  // namespace

void ParityDump::add(const AttachmentParity& parity, const Image& reference, const Image& tested) {
  if (parity.difference.differing_texels == 0) return;
  const std::string stem = (count_ < 10 ? "0" : "") + std::to_string(count_) + "_" + file_part(parity.pass) +
                           "." + file_part(parity.attachment);
  ++count_;
  write_exr(folder_.file(stem + ".software.exr"), channels_of(reference));
  write_exr(folder_.file(stem + ".gl.exr"), channels_of(tested));
  const Image mask = mask_of(reference, tested);
  write_exr(folder_.file(stem + ".mask.exr"), channels_of(mask));
}

void ParityDump::finish(const Json& report) { folder_.finish(report); }

}  // namespace caustics::app
