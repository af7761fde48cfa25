#include "app/cli/commands.h"
#include "app/cli/link_options.h"
#include "app/cli/options.h"
#include "app/cli/output_gate.h"
#include "core/checks/validate.h"
#include "core/io/export/missions/mission_upload.h"
#include "core/io/files/scenario_json.h"
#include "core/io/text/atomic_file.h"
#include "core/link/message/impaired_link.h"
#include "core/link/transport/link_fan_out.h"
#include "core/mission/mission.h"
#include "core/scenario/fields.h"
#include "core/sim/rehearsal_vehicle.h"

#include <CLI/CLI.hpp>
#include <algorithm>

namespace berg::cli {

namespace {

constexpr std::size_t kMostSystems = 250; ///< Ids from 251 are those of ground stations.

struct VehicleArguments
{
    std::string file;
    LinkArguments link;
    std::string uav;
    std::optional<AutopilotFirmware> autopilot;
    double loss_percent = 0;
    double delay_s = 0;
    double speed = 1;
    bool fly = false;
};

/** A UAV of the scenario as a vehicle, with what was reported about it. */
struct FlyingVehicle
{
    std::string id;
    std::unique_ptr<RehearsalVehicle> vehicle;
    std::uint32_t mode = 0;
    int revision = 0;
};

/** The parameters that ground stations show: ids, speed and radii. None can be changed. */
std::vector<std::pair<std::string, double>> parametersOf(const Uav& uav, AutopilotKind kind,
                                                         std::size_t system)
{
    const double radius_m =
        std::max(uav.aircraft.loiterRadius_m.value_or(0), smallestCircle_m(uav.spec));
    const auto id = static_cast<double>(system);
    if (kind == AutopilotKind::Px4)
        return {{"FW_AIRSPD_TRIM", uav.spec.airspeed_mps}, {"MAV_SYS_ID", id},
                {"NAV_ACC_RAD", kRehearsalReach_m},        {"NAV_LOITER_RAD", radius_m},
                {"RTL_RETURN_ALT", uav.spec.altitude_m},   {"SYS_AUTOSTART", 2100}};
    return {{"AIRSPEED_CRUISE", uav.spec.airspeed_mps},
            {"FENCE_ENABLE", 0},
            {"RTL_ALTITUDE", uav.spec.altitude_m},
            {"SYSID_MYGCS", 255},
            {"SYSID_THISMAV", id},
            {"WP_LOITER_RAD", radius_m},
            {"WP_RADIUS", kRehearsalReach_m}};
}

AutopilotKind kindOf(const Uav& uav, const VehicleArguments& arguments)
{
    return arguments.autopilot.value_or(uav.aircraft.firmware) == AutopilotFirmware::Px4
               ? AutopilotKind::Px4
               : AutopilotKind::ArduPilot;
}

/** Puts fence, rally point and mission of the scenario's plan on board and begins to fly it. */
void flyPlan(RehearsalVehicle& vehicle, const Scenario& scenario, const Plan& plan,
             const std::string& uav)
{
    const ExportContent content = exportContent({.scenario = scenario, .plan = plan}, {.uav = uav});
    for (const MissionPart& part : missionParts(content, content.uavs.front()))
        vehicle.load(part.type, part.items);
    vehicle.flyMission();
}

std::vector<std::size_t> chosenUavs(const Scenario& scenario, const VehicleArguments& arguments)
{
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; row < scenario.uavs.size(); ++row)
        if (arguments.uav.empty() || arguments.uav == scenario.uavs[row].id)
            rows.push_back(row);
    if (rows.empty())
        throw wrongOptions("--uav", {IssueId::NoSuchUav, {word(arguments.uav)}});
    if (rows.size() > kMostSystems)
        throw UsageError(
            QT_TRANSLATE_NOOP("CommandLine", "--uav: choose one; a link has at most %1 vehicles"),
            {countOf(kMostSystems)});
    return rows;
}

RehearsalOptions optionsOf(const Scenario& scenario, std::size_t row,
                           const VehicleArguments& arguments)
{
    const Uav& uav = scenario.uavs[row];
    const LocalFrame frame(scenario.origin);
    const AutopilotKind kind = kindOf(uav, arguments);
    return {.side = {.self = {.system = static_cast<std::uint8_t>(row % kMostSystems + 1),
                              .component = 1},
                     .autopilot = kind,
                     .parameters = parametersOf(uav, kind, row % kMostSystems + 1)},
            .uav = uav.spec,
            .home = frame.toGeographic(uav.home_m.value_or(uav.position_m)),
            .wind_mps = scenario.wind_mps,
            .start = frame.toGeographic(uav.position_m),
            .heading_deg = uav.heading_deg,
            .speed = arguments.speed,
            .loiterRadius_m = uav.aircraft.loiterRadius_m.value_or(0)};
}

/** Prints what ground stations have changed: modes and missions. */
void reportChanges(FlyingVehicle& flying)
{
    const VehicleMissions& missions = flying.vehicle->side().missions();
    const int revision = missions.revision(MissionType::Mission);
    const std::uint32_t mode = flying.vehicle->readings().mode;
    if (mode != flying.mode)
        print(rowLabel(word(flying.id)) + "mode " + std::to_string(mode) + '\n');
    if (revision != flying.revision)
        print(rowLabel(word(flying.id)) +
              std::to_string(missions.items(MissionType::Mission).size()) +
              " mission items on board\n");
    flying.mode = mode;
    flying.revision = revision;
}

int runVehicle(const VehicleArguments& arguments, const std::stop_token& stop)
{
    checkFiles({.inputs = {arguments.file},
                .outputs = {{.option = "--tlog", .path = arguments.link.tlog}},
                .force = arguments.link.force});
    const std::unique_ptr<TransportLink> transport = linkOf(arguments.link);
    const Scenario scenario =
        reading([&] { return scenarioFromJson(readFile(arguments.file), arguments.file); });
    printWarnings(arguments.file, validate(scenario));
    const std::vector<std::size_t> rows = chosenUavs(scenario, arguments);
    std::optional<Plan> plan;
    if (arguments.fly)
        plan = naming(arguments.file, [&] { return planFromStart(scenario, {.stop = stop}); });
    if (stop.stop_requested())
        throw Interrupted{};

    TelemetryFile log(arguments.link.tlog);
    ImpairedLink impaired(*transport,
                          {.loss = arguments.loss_percent / 100, .delay_s = arguments.delay_s});
    LinkFanOut links(impaired, rows.size());
    std::vector<FlyingVehicle> fleet;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        RehearsalOptions options = optionsOf(scenario, rows[i], arguments);
        const std::uint8_t system = options.side.self.system;
        if (!arguments.link.tlog.empty())
            options.side.log = [&log](LinkTime now, std::span<const std::uint8_t> frame) {
                log.add(now, frame);
            };
        options.side.logsReceived = i == 0; // each vehicle receives all frames
        FlyingVehicle flying{
            .id = scenario.uavs[rows[i]].id,
            .vehicle = std::make_unique<RehearsalVehicle>(links.user(i), std::move(options))};
        if (plan)
            flyPlan(*flying.vehicle, scenario, *plan, flying.id);
        print(rowLabel(word(flying.id)) + "system " + std::to_string(system) + ", " +
              nameOf(kFirmwareNames, kindOf(scenario.uavs[rows[i]], arguments) == AutopilotKind::Px4
                                         ? AutopilotFirmware::Px4
                                         : AutopilotFirmware::ArduPilot) +
              '\n');
        fleet.push_back(std::move(flying));
    }

    LinkReporter reporter;
    runLink(
        arguments.link.duration_s, stop,
        [&](LinkTime now) {
            impaired.setTime(now.monotonic_s);
            links.collect();
            for (const FlyingVehicle& flying : fleet)
                flying.vehicle->advance(now);
            impaired.setTime(now.monotonic_s);
        },
        [&] {
            reporter.report(*transport);
            std::ranges::for_each(fleet, reportChanges);
            log.flush();
        });
    log.flush();
    return kDone;
}

} // namespace

void addVehicleCommand(CLI::App& app, Action& action)
{
    CLI::App* command = app.add_subcommand(
        "vehicle", "Fly the UAVs of a scenario as MAVLink vehicles for a ground station");
    VehicleArguments& a = argumentsOf(*command, action, runVehicle);
    command->add_option("SCENARIO", a.file, "Scenario (.berg)")->required();
    addLinkOptions(*command, a.link);
    command->get_option("--link")->required();
    command->add_option("--uav", a.uav, "Id of the UAV (all of them)");
    addNamed(*command, "--autopilot", a.autopilot, kFirmwareNames,
             "Behaviour of the autopilot (the UAV's)");
    command->add_flag("--fly", a.fly, "Begin with the plan of the scenario on board and fly it");
    command->add_option("--loss", a.loss_percent, "Lost packets in each direction, % (0)")
        ->check(numberFrom(0, 100));
    command->add_option("--delay", a.delay_s, "Delay in each direction, s (0)")
        ->check(numberFrom(0, 60));
    command->add_option("--speed", a.speed, "Seconds of flight in each second (1)")
        ->check(numberFrom(0.1, 100));
}

} // namespace berg::cli
