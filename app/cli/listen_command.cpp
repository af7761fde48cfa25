#include "app/cli/commands.h"
#include "app/cli/import_rows.h"
#include "app/cli/link_options.h"
#include "app/cli/options.h"
#include "app/cli/output_gate.h"
#include "core/base/number_text.h"
#include "core/io/results/result_csv.h"
#include "core/io/text/atomic_file.h"
#include "core/io/text/read_budget.h"
#include "core/link/link_session.h"
#include "core/link/logs/nmea_log.h"
#include "core/link/logs/recorded_flight.h"
#include "core/link/tracker_list.h"
#include "core/scenario/utc_time.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
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

/** By `NmeaTarget::Kind`. */
constexpr std::array<const char*, 3> kTargetKinds{"radar", "ship", "aid"};

std::string targetLine(const NmeaTarget& target)
{
    std::string line = std::string(kTargetKinds.at(static_cast<std::size_t>(target.kind))) + ' ' +
                       std::to_string(target.id) + "  " + placeText(target.place);
    if (target.speed_mps)
        line += "  " + fixed(*target.speed_mps, 1) + " m/s";
    if (target.course_deg)
        line += "  " + fixed(*target.course_deg, 0) + " deg";
    return line + (target.name.empty() ? "" : "  " + word(target.name)) + '\n';
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

/** Returns true for a regular file that begins as a log of NMEA sentences. */
bool holdsSentences(const std::string& path)
{
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error))
        return false;
    std::ifstream file(path, std::ios::binary);
    std::string start(65'536, '\0');
    file.read(start.data(), static_cast<std::streamsize>(start.size()));
    start.resize(static_cast<std::size_t>(file.gcount()));
    return isNmeaLog(start);
}

/** Reads a log of NMEA sentences: its targets as CSV, and lines that give nothing. */
class SentenceLog
{
public:
    void feed(std::string_view piece)
    {
        while (!piece.empty()) { // by lines, because targets are taken one by one
            const std::size_t end = piece.find('\n');
            const std::string_view line =
                piece.substr(0, end == std::string_view::npos ? end : end + 1);
            piece.remove_prefix(line.size());
            const std::span bytes(reinterpret_cast<const std::uint8_t*>(line.data()), line.size());
            addFixes(m_reader.feed(bytes));
            take();
        }
    }

    void finish()
    {
        addFixes(m_reader.finish());
        take();
    }

    [[nodiscard]] const Rejections& broken() const { return m_broken; }
    [[nodiscard]] const std::string& csv() const { return m_csv; }
    [[nodiscard]] std::size_t rows() const { return m_rows; }

    [[nodiscard]] std::string summary() const
    {
        std::string text;
        const auto add = [&text](const char* what, std::uint64_t count, const char* of) {
            text += rowLabel(what) + std::to_string(count) + ' ' + of + '\n';
        };
        add("positions", m_reader.counts().fixes, "of the own ship");
        for (std::size_t i = 0; i < kTargetKinds.size(); ++i)
            add(kTargetKinds[i], m_targets[i], "reports");
        add("broken", m_broken.count, "lines");
        return text;
    }

private:
    void addFixes(const std::vector<NmeaFix>& fixes)
    {
        for (const NmeaFix& fix : fixes)
            if (fix.place)
                addRow(m_reader.clock_us(), "own", {}, {}, *fix.place, fix.speed_mps,
                       fix.course_deg);
    }

    void take()
    {
        for (const NmeaFinding& finding : m_reader.takeFindings())
            m_broken.add({.line = finding.line, .fault = issueOf(finding.fault)});
        for (const NmeaTarget& target : m_reader.takeTargets()) {
            const auto kind = static_cast<std::size_t>(target.kind);
            ++m_targets.at(kind);
            addRow(target.unix_us, kTargetKinds.at(kind), std::to_string(target.id), target.name,
                   target.place, target.speed_mps, target.course_deg);
        }
    }

    void addRow(std::optional<std::int64_t> unix_us, const char* kind, const std::string& id,
                const std::string& name, const LatLon& place, std::optional<double> speed_mps,
                std::optional<double> course_deg)
    {
        ++m_rows;
        if (unix_us) {
            const std::chrono::sys_time<std::chrono::microseconds> time{
                std::chrono::microseconds(*unix_us)};
            m_csv += utcText(std::chrono::floor<std::chrono::milliseconds>(time), 0);
        }
        m_csv += std::string(",") + kind + ',' + id + ',' + csvField(name) + ',' +
                 fixedText(place.latitude_deg, 7) + ',' + fixedText(place.longitude_deg, 7) + ',' +
                 (speed_mps ? fixedText(*speed_mps, 2) : "") + ',' +
                 (course_deg ? fixedText(*course_deg, 1) : "") + '\n';
    }

    NmeaReader m_reader;
    std::array<std::uint64_t, 3> m_targets{}; ///< by `NmeaTarget::Kind`
    Rejections m_broken;
    std::size_t m_rows = 0;
    std::string m_csv = "time,kind,id,name,latitude,longitude,speed_mps,course_deg\n";
};

int replaySentences(const ListenArguments& arguments, const std::stop_token& stop)
{
    constexpr std::size_t kMostTargets = 2'000'000; // a week of ten targets
    SentenceLog log;
    reading([&] {
        return readPieces(
            arguments.replay, kLargestLog,
            [&](std::string_view piece) {
                log.feed(piece);
                if (log.rows() > readLimit(kMostTargets))
                    failTooLarge(arguments.replay, IssueId::TooManyRows, readLimit(kMostTargets));
            },
            stop);
    });
    log.finish();
    printRows(arguments.replay, log.broken());
    std::vector<NewFile> files;
    if (!arguments.outputFile.empty())
        files.push_back({.path = arguments.outputFile, .content = log.csv()});
    deliver(files, log.summary());
    return kDone;
}

/** Reads a telemetry log and prints what it holds of each vehicle. */
int replayLog(const ListenArguments& arguments, const std::stop_token& stop)
{
    constexpr std::size_t kMostPositions = 10'000'000; // a month at 4 Hz
    checkFiles({.inputs = {arguments.replay},
                .outputs = {{.option = "--output", .path = arguments.outputFile}},
                .force = arguments.link.force});
    if (holdsSentences(arguments.replay))
        return replaySentences(arguments, stop);
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
            std::map<std::pair<NmeaTarget::Kind, std::uint32_t>, NmeaTarget> targets;
            for (NmeaTarget& target : link.takeTargets())
                targets[{target.kind, target.id}] = std::move(target);
            for (const auto& [key, target] : targets)
                print(targetLine(target));
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
        command->add_option("--replay", a.replay,
                            "Telemetry log, or log of NMEA sentences, to read in place of a link");
    for (const char* const ofLink : {"--link", "--tlog", "--duration"})
        replay->excludes(command->get_option(ofLink));
    addOutputFile(*command, "-o,--output", a.outputFile, "CSV file for the positions of the log")
        ->needs(replay);
}

} // namespace berg::cli
