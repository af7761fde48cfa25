#include "core/tracking/position_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace berg {

namespace {

/**
 * Errors by `SightingSource`: estimates to start from, not measurements of the user's own
 * equipment.
 */
constexpr std::array kErrors{
    SourceError{"radar", 150,
                "IMO MSC.192(79) allows a ship's radar 1 degree in bearing and 1 % of the range "
                "scale: 194 m and 222 m at 6 nmi on the 12 nmi scale. Taken as limits of 1.4 "
                "standard deviations."},
    SourceError{"visual", 500,
                "Assumed: a distance of 5 km judged by eye is right to a tenth; 2 degrees of "
                "bearing are less."},
    SourceError{"satellite", 50,
                "Sentinel-1 EW images resolve about 90 m and are placed to some metres "
                "(Schubert et al., Remote Sensing 9, 607, 2017); the middle of an iceberg is found "
                "to about half of that."},
    SourceError{"camera", 20,
                "Assumed: seen from 100 m with an error of 10 degrees in attitude, 18 m."},
    SourceError{"gps-beacon", 25,
                "Assumed: the fix is right to some metres, but the beacon stands anywhere on the "
                "iceberg: 90 m, a medium one, by the root of 12."},
    SourceError{"argos-beacon", 300,
                "Fixes of beacon 1997_12995 of the Canadian Ice Service scatter by about 300 m."},
    SourceError{
        "ais", 30,
        "Assumed: a transponder with satellite navigation, right to 10 m (position accuracy "
        "flag of ITU-R M.1371), that stands anywhere on the iceberg, as a GPS beacon does."},
    SourceError{"aircraft", 1852,
                "Reports of flights are in whole minutes of latitude: a nautical mile."},
};
static_assert(kErrors.size() == std::size(kSightingSources));

struct SourceWord
{
    std::string_view word; ///< in lower case
    SightingSource source;
};
/** Words of logs and tables; digits and punctuation separate them. */
constexpr std::array kWords{
    SourceWord{"radar", SightingSource::Radar},
    SourceWord{"rad", SightingSource::Radar},
    SourceWord{"rdr", SightingSource::Radar},
    SourceWord{"arpa", SightingSource::Radar},
    SourceWord{"vis", SightingSource::Visual},
    SourceWord{"visual", SightingSource::Visual},
    SourceWord{"visually", SightingSource::Visual},
    SourceWord{"eye", SightingSource::Visual},
    SourceWord{"lookout", SightingSource::Visual},
    SourceWord{"sat", SightingSource::Satellite},
    SourceWord{"satellite", SightingSource::Satellite},
    SourceWord{"radarsat", SightingSource::Satellite},
    SourceWord{"rcm", SightingSource::Satellite},
    SourceWord{"sar", SightingSource::Satellite},
    SourceWord{"sentinel", SightingSource::Satellite},
    SourceWord{"envisat", SightingSource::Satellite},
    SourceWord{"landsat", SightingSource::Satellite},
    SourceWord{"terrasar", SightingSource::Satellite},
    SourceWord{"camera", SightingSource::Camera},
    SourceWord{"uav", SightingSource::Camera},
    SourceWord{"drone", SightingSource::Camera},
    SourceWord{"gps", SightingSource::GpsBeacon},
    SourceWord{"gnss", SightingSource::GpsBeacon},
    SourceWord{"iridium", SightingSource::GpsBeacon},
    SourceWord{"argos", SightingSource::ArgosBeacon},
    SourceWord{"ais", SightingSource::Ais},
    SourceWord{"aircraft", SightingSource::Aircraft},
    SourceWord{"airplane", SightingSource::Aircraft},
    SourceWord{"helicopter", SightingSource::Aircraft},
    SourceWord{"flight", SightingSource::Aircraft},
};

template <class Test>
std::optional<SightingSource> sourceWhere(const Test& test)
{
    const auto found = std::ranges::find_if(kErrors, test);
    if (found == kErrors.end())
        return std::nullopt;
    return kSightingSources[found - kErrors.begin()];
}

} // namespace

double radius95_m(double sigma_m2)
{
    return std::sqrt(kChiSquare95 * sigma_m2);
}

double sigmaOfRadius95_m2(double radius_m)
{
    return radius_m * radius_m / kChiSquare95;
}

const SourceError& errorOf(SightingSource source)
{
    return kErrors.at(static_cast<std::size_t>(source));
}

std::optional<SightingSource> sourceNamed(std::string_view name)
{
    return sourceWhere([name](const SourceError& error) { return error.name == name; });
}

std::optional<SightingSource> sourceInWords(std::string_view text)
{
    std::optional<SightingSource> best;
    std::string word;
    const auto finishWord = [&] {
        const auto known = std::ranges::find(kWords, word, &SourceWord::word);
        if (known != kWords.end() && (!best || errorOf(known->source).sd_m < errorOf(*best).sd_m))
            best = known->source;
        word.clear();
    };
    for (const char c : text)
        if (c >= 'A' && c <= 'Z')
            word += static_cast<char>(c - 'A' + 'a');
        else if (c >= 'a' && c <= 'z')
            word += c;
        else
            finishWord();
    finishWord();
    return best;
}

std::optional<SightingSource> sourceWith(double sigma_m2)
{
    return sourceWhere(
        [sigma_m2](const SourceError& error) { return error.sigma_m2() == sigma_m2; });
}

} // namespace berg
