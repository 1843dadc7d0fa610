#include "variants.hpp"

namespace settle::mpm::kernel {

namespace baseline {
extern const Variant variant;
}
#ifdef SETTLE_X86_64_VARIANTS
namespace x86_64_v3 {
extern const Variant variant;
}
namespace x86_64_v4 {
extern const Variant variant;
}
#endif

std::vector<const Variant*> variants_here() {
  std::vector<const Variant*> variants{&baseline::variant};
#ifdef SETTLE_X86_64_VARIANTS
  const auto has_all = [](auto... features) { return (features && ...); };
  if (!has_all(__builtin_cpu_supports("avx2"), __builtin_cpu_supports("fma"), __builtin_cpu_supports("bmi2")))
    return variants;
  variants.push_back(&x86_64_v3::variant);
  if (has_all(__builtin_cpu_supports("avx512f"), __builtin_cpu_supports("avx512bw"), __builtin_cpu_supports("avx512cd"),
              __builtin_cpu_supports("avx512dq"), __builtin_cpu_supports("avx512vl")))
    variants.push_back(&x86_64_v4::variant);
#endif
  return variants;
}

const Variant& best_variant() {
  static const Variant& best = *variants_here().back();
  return best;
}

} // namespace settle::mpm::kernel
