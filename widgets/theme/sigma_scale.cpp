#include "widgets/theme/sigma_scale.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace berg {
namespace {

// Viridis at 20 even steps, sRGB.
constexpr std::array<QRgb, 20> kViridis = {
    0xff440154, 0xff481568, 0xff482677, 0xff453781, 0xff3f4788, 0xff39558c, 0xff32648e,
    0xff2d718e, 0xff287d8e, 0xff238a8d, 0xff1f968b, 0xff20a386, 0xff29af7f, 0xff3cbc75,
    0xff56c667, 0xff74d055, 0xff94d840, 0xffb8de29, 0xffdce318, 0xfffde725};

// L* from 41 to 77 at even steps, sRGB.
constexpr std::array<QRgb, 13> kReds = {0xffbe0000, 0xffc8170c, 0xffd02a15, 0xffd63a1d, 0xffdd4827,
                                        0xffe35432, 0xffe9613b, 0xffef6c45, 0xfff3794f, 0xfff6865a,
                                        0xfff99264, 0xfffc9e6e, 0xffffaa78};

// Ends of the sections for which 3 : 1 holds against sea and panels.
constexpr double kLightEnd = 0.52;
constexpr double kDarkStart = 0.42;

QColor between(std::span<const QRgb> steps, double position)
{
    const double scaled = std::clamp(position, 0.0, 1.0) * static_cast<double>(steps.size() - 1);
    const auto low = std::min(static_cast<std::size_t>(scaled), steps.size() - 2);
    const double t = scaled - static_cast<double>(low);
    const QColor a(steps[low]);
    const QColor b(steps[low + 1]);
    const auto mix = [t](int from, int to) {
        return static_cast<int>(std::lround(from + t * (to - from)));
    };
    return {mix(a.red(), b.red()), mix(a.green(), b.green()), mix(a.blue(), b.blue())};
}

} // namespace

QColor SigmaScale::at(double fraction) const
{
    const double t = std::clamp(fraction, 0.0, 1.0);
    switch (m_ground) {
    case Ground::Light:
        return between(kViridis, kLightEnd * (1 - t));
    case Ground::Dark:
        return between(kViridis, kDarkStart + (1 - kDarkStart) * t);
    case Ground::Night:
        break;
    }
    return between(kReds, t);
}

QColor SigmaScale::colour(double sigma_m2, double full_m2) const
{
    return at(full_m2 > 0 ? sigma_m2 / full_m2 : 0);
}

} // namespace berg
