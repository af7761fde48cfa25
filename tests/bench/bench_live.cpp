// Fluency of the whole window while a mission is flown, at 1280 x 800 without a display.
//
// Each case flies for a few seconds of wall time and prints how much work a paint of the map and a
// frame of the whole window were, how many frames a second came of it, and the longest turn of the
// event loop: the longest wait of a hand on the mouse, and how much of it this thread has worked,
// which is all of it when the machine has nothing else to do. "day" flies 100 icebergs for 24 hours
// as fast as possible and prints the same for the first seconds and the last tenth of it, and the
// memory of the process. "link" flies 12 icebergs without a link, with an idle one and with the
// telemetry of three aircraft at 10 Hz, in turn, and compares the medians.
//
// Use: bench_live [icebergs... | day | link]      (12 40 500 when none are named)

#include "app/window/main_window.h"
#include "core/link/transport/link_clock.h"
#include "core/link/transport/transport_link.h"
#include "core/presets/presets.h"
#include "tests/bench/bench_window.h"
#include "widgets/map/view/map_view.h"
#include "widgets/workspace/workspace.h"

#include <QSettings>
#include <QTemporaryDir>

#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <optional>
#include <string>
#include <thread>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

constexpr int kSettle_ms = 2500; ///< the first plan and its curve
constexpr int kFlight_ms = 5000; ///< length of each case
constexpr double kDay_s = 86400;

/** Value of "VmHWM:" or "VmRSS:", MB; -1 if the system does not report it. */
double memory_mb(const std::string& which)
{
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with(which))
            return std::atof(line.c_str() + which.size()) / 1024;
    return -1;
}

constexpr int kLinkPort = 14'999;

/** Sends the telemetry of three aircraft at 10 Hz until it is destroyed. */
class Telemetry
{
public:
    Telemetry() : m_thread([](const std::stop_token& stop) { run(stop); }) {}

private:
    static LinkMessage message(MessageId id, int aircraft, double time_s)
    {
        const double angle = time_s / 30 + aircraft;
        const auto boot_ms = std::llround(1000 * time_s);
        switch (id) {
        case MessageId::GlobalPositionInt:
            return LinkMessage(id)
                .with("time_boot_ms", boot_ms)
                .with("lat", 470'000'000 + std::llround(90'000 * std::sin(angle)))
                .with("lon", -480'000'000 + std::llround(90'000 * std::cos(angle)))
                .with("alt", 120'000)
                .with("vx", std::llround(2200 * std::cos(angle)))
                .with("vy", std::llround(-2200 * std::sin(angle)));
        case MessageId::Attitude:
            return LinkMessage(id)
                .with("time_boot_ms", boot_ms)
                .withReal("yaw", std::remainder(-angle, 6.283185307));
        case MessageId::VfrHud:
            return LinkMessage(id).withReal("airspeed", 22).withReal("groundspeed", 22);
        case MessageId::Heartbeat:
            return LinkMessage(id)
                .with("type", 1)
                .with("autopilot", 12)
                .with("base_mode", 157)
                .with("custom_mode", 0x04040000)
                .with("system_status", 4);
        default:
            return LinkMessage(id);
        }
    }

    static void run(const std::stop_token& stop)
    {
        constexpr std::array kMessages{
            MessageId::GlobalPositionInt, MessageId::Attitude, MessageId::VfrHud,
            MessageId::BatteryStatus,     MessageId::WindCov,  MessageId::MissionCurrent,
            MessageId::SysStatus,         MessageId::Heartbeat};
        const auto link = openLink({.kind = LinkEndpoint::Kind::UdpSend, .port = kLinkPort});
        std::array<FrameWriter, 3> writers{FrameWriter({.system = 1, .component = 1}),
                                           FrameWriter({.system = 2, .component = 1}),
                                           FrameWriter({.system = 3, .component = 1})};
        while (!stop.stop_requested()) {
            static_cast<void>(link->receive());
            const LinkTime now = linkTimeNow();
            for (std::size_t i = 0; i < writers.size(); ++i)
                for (const MessageId id : kMessages)
                    link->send(0,
                               writers[i].write(message(id, static_cast<int>(i), now.monotonic_s),
                                                now.unix_us));
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
        }
    }

    std::jthread m_thread;
};

/** Time that a flight has cost the GUI thread. */
struct FlightFigures
{
    double paint_ms = 0; ///< median
    double frame_ms = 0; ///< median
    double frames_per_s = 0;
    double busy_percent = 0;
    double longestWork_ms = 0;
};

double medianOf(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return values.empty() ? 0 : quantile(values, 0.5);
}

class Bench
{
public:
    Bench(FrameWatch& application, const Scenario& scenario)
        : m_application(application), m_window(m_workspace, m_interaction, m_settings)
    {
        m_workspace.document().reset(scenario);
        m_window.resize(1280, 800);
        m_window.show();
        m_application.map = &m_window.mapView();
        m_application.window = &m_window;
        watchTurns(kSettle_ms);
    }
    ~Bench()
    {
        m_application.map = nullptr;
        m_application.window = nullptr;
    }
    Bench(const Bench&) = delete;
    Bench& operator=(const Bench&) = delete;

    /** Flies at `rate`, as in `Workspace::fly`. */
    FlightFigures fly(const char* name, FlightRate rate)
    {
        m_workspace.reset();
        watchTurns(kSettle_ms);
        m_workspace.fly(rate);
        const FlightFigures figures = report(name, [this] { return hasEnded(); });
        m_workspace.pause();
        return figures;
    }

    /** Compares flights without and with a link, in turn so that other programs hit all alike. */
    void flyWithLink()
    {
        constexpr int kRounds = 5;
        const std::array<const char*, 3> names{"no link", "idle link", "three aircraft at 10 Hz"};
        std::array<std::vector<FlightFigures>, 3> figures;
        for (int round = 0; round < kRounds; ++round)
            for (std::size_t i = 0; i < names.size(); ++i) {
                std::optional<Telemetry> telemetry;
                if (i > 0)
                    m_workspace.link().listen([] {
                        return openLink({.kind = LinkEndpoint::Kind::UdpListen, .port = kLinkPort});
                    });
                if (i > 1)
                    telemetry.emplace();
                figures[i].push_back(fly(names[i], 50));
                if (i > 1)
                    std::printf("    %zu aircraft heard\n",
                                m_workspace.link().status().vehicles.size());
                m_workspace.link().stop();
            }
        const auto median = [&](std::size_t i, double FlightFigures::*figure) {
            std::vector<double> values;
            for (const FlightFigures& each : figures[i])
                values.push_back(each.*figure);
            return medianOf(values);
        };
        std::printf("  medians of %d rounds, and ratios to no link\n", kRounds);
        const std::array<std::pair<const char*, double FlightFigures::*>, 5> rows{
            {{"map paint, ms", &FlightFigures::paint_ms},
             {"window frame, ms", &FlightFigures::frame_ms},
             {"frames/s", &FlightFigures::frames_per_s},
             {"GUI thread at work, %", &FlightFigures::busy_percent},
             {"longest work, ms", &FlightFigures::longestWork_ms}}};
        for (const auto& [name, figure] : rows)
            std::printf("    %-24s %7.2f   %7.2f (%.2f)   %7.2f (%.2f)\n", name, median(0, figure),
                        median(1, figure), median(1, figure) / median(0, figure), median(2, figure),
                        median(2, figure) / median(0, figure));
    }

    void flyADay()
    {
        std::printf("  memory before take-off %.0f MB\n", memory_mb("VmRSS:"));
        m_workspace.fly(kFastestRate);
        QElapsedTimer clock;
        clock.start();
        report("day, first seconds", [this] { return hasEnded(); });
        while (!hasEnded() && now().time_s < 0.9 * kDay_s)
            watchTurns(kFlight_ms, [this] { return hasEnded() || now().time_s >= 0.9 * kDay_s; });
        report("day, last tenth", [this] { return hasEnded(); });
        std::printf(
            "  flown %.0f s in %.1f s, memory %.0f MB, at most %.0f MB, %zu samples, %zu plans\n",
            now().time_s, elapsed_ms(clock) / 1000, memory_mb("VmRSS:"), memory_mb("VmHWM:"),
            m_workspace.record().history.samples.size(), m_workspace.record().history.plans.size());
    }

private:
    [[nodiscard]] const MissionSnapshot& now() const { return m_workspace.record().now; }
    [[nodiscard]] bool hasEnded() const
    {
        return now().phase == RunPhase::Finished || now().phase == RunPhase::Failed;
    }

    FlightFigures report(const char* name, const std::function<bool()>& mayEnd)
    {
        m_application.paints_ms.clear();
        m_application.frames_ms.clear();
        m_application.longest = {};
        const double from_s = now().time_s;
        QElapsedTimer clock;
        clock.start();
        const double before_ms = worked_ms();
        const LongestTurn longest = watchTurns(kFlight_ms, mayEnd);
        const double busy_ms = worked_ms() - before_ms;
        const double wall_s = elapsed_ms(clock) / 1000;
        std::printf("  %s: %.0f s flown in %.1f s\n", name, now().time_s - from_s, wall_s);
        print("map paint", m_application.paints_ms);
        print("window frame", m_application.frames_ms);
        std::printf("    %.1f frames/s, longest block %.1f ms (%.1f ms of work), at work %.0f %%\n",
                    static_cast<double>(m_application.paints_ms.size()) / wall_s, longest.waited_ms,
                    longest.worked_ms, busy_ms / wall_s / 10);
        std::printf("    longest event: %.1f ms of work, type %d to %s\n",
                    m_application.longest.work_ms, m_application.longest.type,
                    m_application.longest.receiver.c_str());
        std::fflush(stdout);
        return {.paint_ms = medianOf(m_application.paints_ms),
                .frame_ms = medianOf(m_application.frames_ms),
                .frames_per_s = static_cast<double>(m_application.paints_ms.size()) / wall_s,
                .busy_percent = busy_ms / wall_s / 10,
                .longestWork_ms = longest.worked_ms};
    }

    FrameWatch& m_application;
    QTemporaryDir m_folder;
    QSettings m_settings{m_folder.filePath(u"settings.ini"_s), QSettings::IniFormat};
    NoDialogs m_interaction;
    Workspace m_workspace;
    MainWindow m_window;
};

Scenario fieldOf(int icebergs)
{
    Scenario scenario = randomScenario(1, {.icebergs = icebergs});
    scenario.duration_s = 7200;
    return scenario;
}

/** Flies a day with a policy that takes no time, to measure the window alone. */
Scenario dayOf(int icebergs)
{
    Scenario scenario = fieldOf(icebergs);
    scenario.duration_s = kDay_s;
    scenario.planner.policy = PolicyKind::Nearest;
    return scenario;
}

} // namespace

int main(int argc, char* argv[])
{
    if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    FrameWatch application(argc, argv);
    std::vector<std::string> cases(argv + 1, argv + argc);
    if (cases.empty())
        cases = {"12", "40", "500"};
    for (const std::string& name : cases) {
        if (name == "day") {
            std::printf("100 icebergs for 24 h\n");
            Bench(application, dayOf(100)).flyADay();
            continue;
        }
        if (name == "link") {
            std::printf("12 icebergs with a link\n");
            Bench(application, fieldOf(12)).flyWithLink();
            continue;
        }
        std::printf("%s icebergs\n", name.c_str());
        Bench bench(application, fieldOf(std::atoi(name.c_str())));
        bench.fly("50 x", 50);
        bench.fly("100 x", 100);
        bench.fly("as fast as possible", kFastestRate);
    }
    return 0;
}
