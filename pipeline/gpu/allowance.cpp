#include "pipeline/gpu/allowance.hpp"

namespace caustics {

namespace {

bool matches(const std::string& pattern, const std::string& name) {
  return pattern == "*" || pattern == name;
}

}  // namespace

AllowanceBook::AllowanceBook(const std::string& driver, std::vector<Allowance> allowances)
    : allowances_(std::move(allowances)) {
  std::erase_if(allowances_, [&](const Allowance& a) { return a.driver != driver; });
  used_.resize(allowances_.size());
}

const Allowance* AllowanceBook::covers(const std::string& pass, const std::string& attachment,
                                       const ImageDifference& difference) {
  const ValueDifference& all = difference.all;
  if (!difference.same_shape || all.nan_only_a + all.nan_only_b + all.infinite > 0) return nullptr;
  const double share =
      static_cast<double>(difference.differing_texels) / static_cast<double>(difference.texels);
  for (std::size_t i = 0; i < allowances_.size(); ++i) {
    const Allowance& a = allowances_[i];
    if (!matches(a.pass, pass) || !matches(a.attachment, attachment)) continue;
    used_[i] = true;
    if (share <= a.texels && all.relative.p999 <= a.relative) return &a;
  }
  return nullptr;
}

std::vector<Allowance> AllowanceBook::unused() const {
  std::vector<Allowance> result;
  for (std::size_t i = 0; i < allowances_.size(); ++i) {
    if (!used_[i]) result.push_back(allowances_[i]);
  }
  return result;
}

}  // namespace caustics
