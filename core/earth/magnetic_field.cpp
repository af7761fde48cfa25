#include "core/earth/magnetic_field.h"

#include "core/base/angles.h"

#include <GeographicLib/Geocentric.hpp>
#include <GeographicLib/SphericalHarmonic.hpp>
#include <array>
#include <cmath>
#include <vector>

namespace berg {

namespace {

constexpr int kDegree = 12;
constexpr double kEpoch_year = 2025;
constexpr double kEnd_year = 2030;
constexpr double kRadius_m = 6'371'200;
constexpr double kBlackout_nanotesla = 2000;

struct GaussCoefficient
{
    int degree = 0;
    int order = 0;
    double g_nanotesla = 0;
    double h_nanotesla = 0;
    double gChange_nanotesla = 0; ///< change per year
    double hChange_nanotesla = 0;
};

constexpr std::array<GaussCoefficient, 90> kCoefficients{{
#include "core/earth/magnetic_coefficients.inc"
}};

/** Coefficients of one year, sorted by order as GeographicLib requires. */
struct Harmonics
{
    std::vector<double> cosines = std::vector<double>((kDegree + 1) * (kDegree + 2) / 2);
    std::vector<double> sines = std::vector<double>(kDegree * (kDegree + 1) / 2);
};

Harmonics harmonicsOf(double year)
{
    Harmonics harmonics;
    for (const GaussCoefficient& c : kCoefficients) {
        const int packed = c.order * kDegree - c.order * (c.order - 1) / 2 + c.degree;
        const auto place = static_cast<std::size_t>(packed);
        harmonics.cosines[place] = c.g_nanotesla + (year - kEpoch_year) * c.gChange_nanotesla;
        if (c.order > 0) // the sines follow those of order 0
            harmonics.sines[place - (kDegree + 1)] =
                c.h_nanotesla + (year - kEpoch_year) * c.hChange_nanotesla;
    }
    return harmonics;
}

} // namespace

std::optional<MagneticField> magneticField(LatLon place, double height_m, double year)
{
    if (!(year >= kEpoch_year && year < kEnd_year))
        return std::nullopt;
    const Harmonics harmonics = harmonicsOf(year);
    const GeographicLib::SphericalHarmonic potential(harmonics.cosines, harmonics.sines, kDegree,
                                                     kRadius_m,
                                                     GeographicLib::SphericalHarmonic::SCHMIDT);
    double x_m = 0;
    double y_m = 0;
    double z_m = 0;
    std::vector<double> rotation(9); // from east, north, up
    GeographicLib::Geocentric::WGS84().Forward(place.latitude_deg, place.longitude_deg, height_m,
                                               x_m, y_m, z_m, rotation);
    std::array<double, 3> slope{}; // nT/m along the radius
    potential(x_m, y_m, z_m, slope[0], slope[1], slope[2]);
    const auto along = [&](std::size_t axis) {
        return -kRadius_m * (rotation[axis] * slope[0] + rotation[axis + 3] * slope[1] +
                             rotation[axis + 6] * slope[2]);
    };
    return MagneticField{
        .east_nanotesla = along(0), .north_nanotesla = along(1), .up_nanotesla = along(2)};
}

std::optional<double> magneticDeclination_deg(LatLon place, double year)
{
    const std::optional<MagneticField> field = magneticField(place, 0, year);
    if (!field || std::hypot(field->east_nanotesla, field->north_nanotesla) < kBlackout_nanotesla)
        return std::nullopt;
    return degFromRad(std::atan2(field->east_nanotesla, field->north_nanotesla));
}

} // namespace berg
