#include "app/cli/commands.h"
#include "app/cli/link_options.h"
#include "app/cli/options.h"
#include "app/cli/output_gate.h"
#include "core/base/number_text.h"
#include "core/io/text/atomic_file.h"
#include "core/io/text/read_budget.h"
#include "core/io/text/utc_time.h"
#include "core/link/link_session.h"
#include "core/link/recorded_flight.h"
#include "core/link/tracker_list.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <utility>

namespace berg::cli {

namespace {

std::string placeText(const LatLon& place)
{
    return fixed(place.latitude_deg, 6) + ' ' + fixed(place.longitude_deg, 6);
}

/** Returns the line of one vehicle: id, mode, position, speed, wind, battery, item. */
std::string lineOf(const LinkVehicle& vehicle)
{
    const AircraftState& state = vehicle.state;
    std::string line = std::to_string(vehicle.address.system) + '/' +
                       std::to_string(vehicle.address.component) +
                       (vehicle.autopilot == AutopilotKind::ArduPilot ? "  ardupilot"
                        : vehicle.autopilot == AutopilotKind::Px4     ? "  px4"
                                                                      : "  other") +
                       "  mode " + std::to_string(vehicle.mode) + (vehicle.isLost ? "  lost" : "");
    if (state.position)
        line += "  " + placeText(state.position->place) + "  " +
                fixed(state.position->altitude_m, 1) + " m  " +
                fixed(std::hypot(state.position->north_mps, state.position->east_mps), 1) + " m/s";
    if (state.wind)
        line += "  wind " +
                fixed(std::hypot(state.wind->meanNorth_mps, state.wind->meanEast_mps), 1) + " m/s";
    if (state.battery && state.battery->remaining)
        line += "  battery " + fixed(100 * *state.battery->remaining, 0) + " %";
    if (state.mission)
        line += "  item " + std::to_string(state.mission->item);
    const double sent = static_cast<double>(vehicle.loss.received + vehicle.loss.lost);
    if (vehicle.loss.lost > 0)
        line += "  loss " + fixed(100 * static_cast<double>(vehicle.loss.lost) / sent, 1) + " %";
    return line + '\n';
}

std::string fixLine(const std::string& peer, const NmeaFix& fix)
{
    std::string line = peer + "  nmea " + fix.talker + fix.sentence + "  " + placeText(*fix.place);
    if (fix.altitude_m)
        line += "  " + fixed(*fix.altitude_m, 1) + " m";
    if (fix.speed_mps)
        line += "  " + fixed(*fix.speed_mps, 1) + " m/s";
    if (fix.course_deg)
        line += "  " + fixed(*fix.course_deg, 0) + " deg";
    return line + '\n';
}

void printEvents(const LinkUpdate& update)
{
    for (const LinkEvent& event : update.events)
        if (event.kind == LinkEvent::Kind::Text) // from the air: `print` makes it harmless
            print(std::to_string(event.vehicle.system) + '/' +
                  std::to_string(event.vehicle.component) + "  text " + word(event.text) + '\n');
}

struct ListenArguments
{
    LinkArguments link;
    std::string replay;
    std::string outputFile;
};

/** Returns the positions of a telemetry log as CSV, in the order of vehicles and times. */
std::string flightsCsv(const FlightRecorder& recorder)
{
    std::string csv = "time,system,component,latitude,longitude,altitude_m\n";
    for (const auto& [address, positions] : recorder.flights())
        for (const RecordedPosition& position : positions) {
            const std::chrono::sys_time<std::chrono::microseconds> time{
                std::chrono::microseconds(position.unix_us)};
            csv += utcText(std::chrono::floor<std::chrono::milliseconds>(time), 0) + ',' +
                   std::to_string(address.system) + ',' + std::to_string(address.component) + ',' +
                   fixedText(position.place.latitude_deg, 7) + ',' +
                   fixedText(position.place.longitude_deg, 7) + ',' +
                   fixedText(position.altitude_m, 3) + '\n';
        }
    return csv;
}

/** Reads a telemetry log and prints what it holds of each vehicle. */
int replayLog(const ListenArguments& arguments, const std::stop_token& stop)
{
    constexpr std::size_t kMostPositions = 10'000'000; // a month at 4 Hz
    checkFiles({.inputs = {arguments.replay},
                .outputs = {{.option = "--output", .path = arguments.outputFile}},
                .force = arguments.link.force});
    TelemetryLogReader reader;
    FlightRecorder recorder;
    std::uint64_t frames = 0;
    std::size_t positions = 0;
    const auto addAll = [&](const std::vector<LoggedFrame>& found) {
        frames += found.size();
        for (const LoggedFrame& each : found)
            if (recorder.add(each))
                ++positions;
        if (positions > readLimit(kMostPositions))
            failTooLarge(arguments.replay, IssueId::TooManyRows, readLimit(kMostPositions));
    };
    const auto addPiece = [&](std::string_view piece) {
        addAll(reader.feed({reinterpret_cast<const std::uint8_t*>(piece.data()), piece.size()}));
    };
    const std::size_t size =
        reading([&] { return readPieces(arguments.replay, kLargestLog, addPiece, stop); });
    addAll(reader.finish());
    if (frames == 0 && size > 0) {
        printMessage(said(QT_TRANSLATE_NOOP("CommandLine", "%1 is no telemetry log"),
                          {word(arguments.replay)}));
        return kBadInput;
    }
    std::string text = "frames    " + std::to_string(frames) + ", " +
                       std::to_string(reader.skipped_bytes()) + " bytes skipped\n";
    for (const auto& [address, positions] : recorder.flights()) {
        const double flown_s =
            static_cast<double>(positions.back().unix_us - positions.front().unix_us) / 1e6;
        text += rowLabel(std::to_string(address.system) + '/' + std::to_string(address.component)) +
                std::to_string(positions.size()) + " positions in " + fixed(flown_s, 1) + " s\n";
    }
    std::vector<NewFile> files;
    if (!arguments.outputFile.empty())
        files.push_back({.path = arguments.outputFile, .content = flightsCsv(recorder)});
    deliver(files, text);
    return kDone;
}

int runListen(const ListenArguments& given, const std::stop_token& stop)
{
    const LinkArguments& arguments = given.link;
    if (!given.replay.empty())
        return replayLog(given, stop);
    if (arguments.link.empty())
        throw UsageError(QT_TRANSLATE_NOOP("CommandLine", "%1 is required"), {"--link, --replay"});
    checkFiles(
        {.outputs = {{.option = "--tlog", .path = arguments.tlog}}, .force = arguments.force});
    const std::unique_ptr<TransportLink> transport = linkOf(arguments);
    TelemetryFile log(arguments.tlog);
    TrackerLink link(*transport); // nothing is sent, because the session never begins to
    LinkSession session(link, {.log = [&log](LinkTime now, std::span<const std::uint8_t> frame) {
                            log.add(now, frame);
                        }});
    LinkReporter reporter;
    runLink(
        arguments.duration_s, stop, [&](LinkTime now) { printEvents(session.advance(now)); },
        [&] {
            reporter.report(*transport);
            for (const LinkVehicle& vehicle : session.vehicles())
                print(lineOf(vehicle));
            std::map<int, NmeaFix> newest;
            for (TrackerFix& received : link.takeFixes())
                if (received.fix.place)
                    newest[received.peer] = std::move(received.fix);
            for (const auto& [peer, fix] : newest)
                print(fixLine(transport->peerName(peer), fix));
            log.flush();
        });
    log.flush();
    return kDone;
}

} // namespace

void addListenCommand(CLI::App& app, Action& action)
{
    CLI::App* command = app.add_subcommand(
        "listen", "Print what vehicles and NMEA receivers send over a link; send nothing");
    ListenArguments& a = argumentsOf(*command, action, runListen);
    addLinkOptions(*command, a.link);
    CLI::Option* const replay =
        command->add_option("--replay", a.replay, "Telemetry log to read in place of a link");
    for (const char* const ofLink : {"--link", "--tlog", "--duration"})
        replay->excludes(command->get_option(ofLink));
    addOutputFile(*command, "-o,--output", a.outputFile, "CSV file for the positions of the log")
        ->needs(replay);
}

} // namespace berg::cli
