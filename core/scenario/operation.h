#pragma once

#include "core/scenario/limits.h"
#include "core/scenario/scenario.h"

#include <array>
#include <string_view>

namespace berg {

/** A number of an operation by its name in the scenario file. */
struct OperationNumber
{
    std::string_view name;
    double Operation::*member = nullptr;
    Limits limits;
};

/** All of them: readers, checks and input fields ask here. */
inline constexpr std::array kOperationNumbers{
    OperationNumber{"margin_m", &Operation::margin_m, limits::kExtent_m},
    OperationNumber{"span_m", &Operation::span_m, limits::kSmallError_m},
    OperationNumber{"position_error_m", &Operation::positionError_m, limits::kSmallError_m},
    OperationNumber{"path_error_m", &Operation::pathError_m, limits::kSmallError_m},
    OperationNumber{"map_error_m", &Operation::mapError_m, limits::kSmallError_m},
    OperationNumber{"reaction_s", &Operation::reaction_s, limits::kReaction_s},
    OperationNumber{"turn_bank_deg", &Operation::turnBank_deg, limits::kBank_deg},
    OperationNumber{"height_error_m", &Operation::heightError_m, limits::kSmallError_m},
    OperationNumber{"climb_part", &Operation::climbPart, limits::kPart},
    OperationNumber{"pull_up_part", &Operation::pullUpPart, limits::kPart},
    OperationNumber{"buffer_ratio", &Operation::bufferRatio, limits::kPart},
    OperationNumber{"adjacent_s", &Operation::adjacent_s, limits::kTime_s},
    OperationNumber{"adjacent_least_m", &Operation::adjacentLeast_m, limits::kLength_m},
    OperationNumber{"adjacent_most_m", &Operation::adjacentMost_m, limits::kLength_m}};

/** A text of an operation, likewise. */
struct OperationText
{
    std::string_view name;
    std::string Operation::*member = nullptr;
};

inline constexpr std::array kOperationTexts{
    OperationText{"crew", &Operation::crew}, OperationText{"call_sign", &Operation::callSign},
    OperationText{"contacts", &Operation::contacts}, OperationText{"link", &Operation::link},
    OperationText{"checklist", &Operation::checklist}};

/** From the inside out; each holds the ones before. */
enum class VolumePart
{
    Geography,   ///< what is flown in
    Contingency, ///< what a flight that leaves it needs to come back
    Buffer,      ///< where it may come down
    Adjacent     ///< what it might reach if nobody stopped it
};
inline constexpr std::size_t kVolumeParts = 4;
/** Names in exported files, by part. */
inline constexpr std::array<std::string_view, kVolumeParts> kVolumePartIds{
    "flight-geography", "contingency-volume", "ground-risk-buffer", "adjacent-area"};

/** An operation volume by the formulas of `operationVolume`. */
struct OperationVolume
{
    double speed_mps = 0;                                    ///< v
    double height_m = 0;                                     ///< H_FG
    double ceiling_m = 0;                                    ///< H_CV
    double outside_m = 0;                                    ///< S_CV
    double buffer_m = 0;                                     ///< S_GRB
    double adjacent_m = 0;                                   ///< S_AA
    std::array<std::vector<Point>, kVolumeParts> outlines_m; ///< by part, counter-clockwise

    [[nodiscard]] const std::vector<Point>& outline_m(VolumePart part) const
    {
        return outlines_m[static_cast<std::size_t>(part)];
    }
    /** Above the sea; none: of what is on the ground, and of all heights. */
    [[nodiscard]] std::optional<double> top_m(VolumePart part) const
    {
        if (part == VolumePart::Geography)
            return height_m;
        return part == VolumePart::Contingency ? std::optional(ceiling_m) : std::nullopt;
    }
};

/**
 * Proposal for the volume of an operation, to be checked with the authority that permits it.
 *
 * Flight geography: inside of the geofence; without one the hull of all places that a plan may lead
 * to (where UAVs start and land, where icebergs are expected from first to last) with the margin.
 * Its height H_FG is the altitude of the highest UAV, v the largest speed over ground.
 *
 *   S_CV = position + path + map error + v t + v^2 / (g tan bank)
 *   H_CV = H_FG + height error + climb part v t + pull-up part v^2 / g
 *   S_GRB = ratio H_CV + span / 2
 *   S_AA = v adjacent time, within its least and most
 *
 * with t the reaction time; S_AA counts from the contingency volume. Formulas and defaults are
 * those of the calculator of Digisky (version 3.3.0), which follows the guide of the Swiss FOCA; no
 * authority's own text. At 22 m/s and 120 m S_CV is 114 m and H_CV 154 m. The scenario must have a
 * UAV. Cost: small, corners of the geofence squared.
 */
[[nodiscard]] OperationVolume operationVolume(const Scenario& scenario, const Operation& operation);

} // namespace berg
