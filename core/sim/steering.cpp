#include "core/sim/steering.h"

#include "core/link/autopilot_modes.h"

#include <array>
#include <cmath>

namespace berg {

namespace {

constexpr AutopilotModes kPlane = autopilotModes(AutopilotKind::ArduPilot);
constexpr AutopilotModes kPx4 = autopilotModes(AutopilotKind::Px4);

struct NamedMode
{
    std::uint32_t mode;
    const char* name;
};

constexpr std::array<NamedMode, 22> kPlaneModes{{
    {0, "MANUAL"},
    {1, "CIRCLE"},
    {2, "STABILIZE"},
    {3, "TRAINING"},
    {4, "ACRO"},
    {5, "FBWA"},
    {6, "FBWB"},
    {7, "CRUISE"},
    {8, "AUTOTUNE"},
    {kPlane.mission, "AUTO"},
    {kPlane.home, "RTL"},
    {kPlane.hold, "LOITER"},
    {13, "TAKEOFF"},
    {14, "AVOID"},
    {kPlane.guided, "GUIDED"},
    {17, "QSTABILIZE"},
    {18, "QHOVER"},
    {19, "QLOITER"},
    {20, "QLAND"},
    {21, "QRTL"},
    {24, "THERMAL"},
    {26, "AUTOLAND"},
}};

/** Main mode in the third byte, sub-mode of automatic flight in the highest. */
constexpr std::array<NamedMode, 12> kPx4Modes{{
    {0x00010000, "Manual"},
    {0x00020000, "Altitude"},
    {0x00030000, "Position"},
    {0x00050000, "Acro"},
    {0x00060000, "Offboard"},
    {0x00070000, "Stabilized"},
    {0x01040000, "Ready"},
    {0x02040000, "Takeoff"},
    {kPx4.hold, "Hold"},
    {kPx4.mission, "Mission"},
    {kPx4.home, "Return"},
    {0x06040000, "Land"},
}};

} // namespace

void Steering::begin(SteeringKind kind, AutopilotKind autopilot, std::uint32_t mode)
{
    m_kind = kind;
    m_wanted = steeringMode(kind, autopilot);
    m_former = mode;
    m_needsTarget = kind == SteeringKind::Guided && autopilot == AutopilotKind::Px4;
    m_isTargetSent = false;
    m_state = kind == SteeringKind::None ? SteeringState::Off : SteeringState::Waiting;
    setMode(mode);
}

void Steering::setMode(std::uint32_t mode)
{
    if (m_state != SteeringState::Waiting && m_state != SteeringState::Active)
        return;
    const bool isPilots = m_state == SteeringState::Waiting && m_needsTarget && !m_isTargetSent;
    if (mode == m_wanted && !isPilots)
        m_state = SteeringState::Active;
    else if (m_state == SteeringState::Active || mode != m_former)
        m_state = SteeringState::PilotTookOver;
}

std::uint32_t steeringMode(SteeringKind kind, AutopilotKind autopilot)
{
    const AutopilotModes modes = autopilotModes(autopilot);
    return kind == SteeringKind::Guided ? modes.guided : modes.mission;
}

std::string modeName(AutopilotKind autopilot, std::uint32_t mode)
{
    const auto find = [mode](const auto& modes) -> std::string {
        for (const NamedMode& row : modes)
            if (row.mode == mode)
                return row.name;
        return std::to_string(mode);
    };
    return autopilot == AutopilotKind::Px4         ? find(kPx4Modes)
           : autopilot == AutopilotKind::ArduPilot ? find(kPlaneModes)
                                                   : std::to_string(mode);
}

LinkCommand modeCommand(AutopilotKind autopilot, std::uint32_t mode)
{
    LinkCommand command{.command = LinkCommandId::kSetMode, .params = {1}}; // custom mode
    if (autopilot == AutopilotKind::Px4) {
        command.params[1] = (mode >> 16U) & 0xFFU;
        command.params[2] = mode >> 24U;
    } else {
        command.params[1] = mode;
    }
    return command;
}

LinkCommand itemCommand(AutopilotKind autopilot, int item)
{
    const int home = autopilot == AutopilotKind::ArduPilot ? 1 : 0;
    return {.command = LinkCommandId::kSetCurrentItem,
            .params = {static_cast<double>(item + home)}};
}

std::optional<LinkCommand> guidedCommand(AutopilotKind autopilot, const GuidedPoint& point,
                                         const std::optional<double>& homeAltitude_m)
{
    const bool isPx4 = autopilot == AutopilotKind::Px4;
    if (isPx4 && !homeAltitude_m)
        return std::nullopt;
    constexpr double kChangeMode = 1; // bit of p2; p1 = -1 keeps the speed
    return LinkCommand{.command = LinkCommandId::kReposition,
                       .params = {-1, kChangeMode, point.radius_m, 0,
                                  std::round(point.place.latitude_deg * 1e7),
                                  std::round(point.place.longitude_deg * 1e7),
                                  isPx4 ? *homeAltitude_m + point.aboveHome_m : point.aboveHome_m},
                       .frame = isPx4 ? ItemFrame::Global : ItemFrame::AboveHome};
}

double beyond_m(double radius_m, double speed_mps, double delay_s)
{
    return 1.5 * radius_m + speed_mps * delay_s;
}

} // namespace berg
