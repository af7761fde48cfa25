#include "tests/core/layering_rules.h"

#include <QtTest>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

using berg::test::kModules;
using berg::test::kRooms;
using berg::test::Module;

namespace {

namespace fs = std::filesystem;

struct Include
{
    std::string target;
    bool quoted = false; ///< "..." rather than <...>
};

/** Returns the include of a source line, or nullopt if the line is another one or a comment. */
std::optional<Include> includeOf(const std::string& line)
{
    if (line.find('#') == std::string::npos)
        return std::nullopt; // This is early for most lines.
    static const std::regex pattern(R"(^\s*#\s*include\s*([<"])([^">]+)[">])");
    std::smatch match;
    if (!std::regex_search(line, match, pattern))
        return std::nullopt;
    return Include{.target = match[2], .quoted = match[1] == "\""};
}

/** Returns the module of a path, or an empty text for files outside core/. */
std::string moduleOf(std::string_view path)
{
    constexpr std::string_view kCore = "core/";
    if (!path.starts_with(kCore))
        return {};
    path.remove_prefix(kCore.size());
    return std::string(path.substr(0, path.find('/')));
}

bool startsWithAny(std::string_view text, const std::vector<std::string_view>& prefixes)
{
    return std::any_of(prefixes.begin(), prefixes.end(),
                       [&](std::string_view prefix) { return text.starts_with(prefix); });
}

/** Returns the fault of a third-party header in this file, or an empty text. */
std::string thirdPartyFault(const std::string& file, const std::string& target)
{
    if (target.starts_with('Q') || target.starts_with("qt") || target.starts_with("ui_"))
        return "Qt belongs to widgets/ and app/";
    if (startsWithAny(target, {"Cbc", "Cgl", "Coin", "Clp", "Osi", "coin/"}) &&
        !file.starts_with("core/cbc/"))
        return "COIN belongs to core/cbc, which is linked by bergwatch-cbc alone";
    if (target == "expat.h" && file != "core/io/text/xml_reader.cpp")
        return "Expat belongs to core/io/text/xml_reader.cpp";
    if (target.starts_with("netcdf") && file != "core/io/import/forecast/netcdf_file.cpp")
        return "libnetcdf belongs to core/io/import/forecast/netcdf_file.cpp";
    if (target == "eccodes.h" && file != "core/io/import/forecast/grib_forecast.cpp")
        return "ecCodes belongs to core/io/import/forecast/grib_forecast.cpp";
    if (target.starts_with("GeographicLib") &&
        !startsWithAny(file, {"core/earth/geodesy.", "core/earth/coordinates.",
                              "core/earth/magnetic_field.", "core/earth/map_projection."}))
        return "GeographicLib belongs to core/earth/geodesy, coordinates, magnetic_field and "
               "map_projection";
    return {};
}

/** Returns whether the file is in app/ and belongs to the window. */
bool isOfWindow(std::string_view file)
{
    return file.starts_with("app/") && !file.starts_with("app/cli/");
}

std::string folderOf(const std::string& path)
{
    return path.substr(0, path.rfind('/'));
}

/** Returns the fault of an include between rooms, or an empty text. */
std::string roomFault(const std::string& file, const std::string& target)
{
    const auto roomNamed = [](const std::string& name) {
        return std::find_if(kRooms.begin(), kRooms.end(),
                            [&](const Module& room) { return room.name == name; });
    };
    const std::string from = folderOf(file);
    const std::string to = folderOf(target);
    const auto room = roomNamed(from);
    if (room == kRooms.end() || roomNamed(to) == kRooms.end() || from == to)
        return {};
    const bool isOfAnotherModule =
        moduleOf(file) != moduleOf(target) || // The table of modules decides this.
        isOfWindow(file) != isOfWindow(target);
    return isOfAnotherModule || room->mayInclude.contains(to) ? "" : from + " may not use " + to;
}

/** Returns the fault of an include of this project, or an empty text. */
std::string ownFault(const std::string& file, const std::string& target)
{
    if (file.starts_with("widgets/"))
        return target.starts_with("app/") ? "the window's parts do not know the window"
                                          : roomFault(file, target);
    if (isOfWindow(file))
        return roomFault(file, target);
    const std::string from = moduleOf(file);
    const std::string to = moduleOf(target);
    if (from.empty()) // This file belongs to the command line.
        return target.starts_with("core/") || target.starts_with("app/cli/")
                   ? roomFault(file, target)
                   : "the command line uses the core only";
    if (to.empty())
        return "below core/, includes are root-relative and stay in core/";
    const auto module = std::find_if(kModules.begin(), kModules.end(),
                                     [&](const Module& m) { return m.name == from; });
    if (module == kModules.end())
        return "module " + from + " is not in the table of layers";
    if (to == from)
        return roomFault(file, target);
    return module->mayInclude.contains(to) ? "" : from + " may not use " + to;
}

/** Returns the fault of one line of `file` (path from the project's root), or an empty text. */
std::string faultOf(const std::string& file, const std::string& line)
{
    const std::optional<Include> include = includeOf(line);
    if (!include)
        return {};
    const bool mayUseQt = file.starts_with("widgets/") || isOfWindow(file);
    std::string fault = mayUseQt ? "" : thirdPartyFault(file, include->target);
    if (fault.empty() && startsWithAny(include->target, {"nlohmann", "QJson"}) &&
        moduleOf(file) != "io")
        fault = "JSON belongs to core/io"; // Qt's as well
    if (fault.empty() && include->quoted)
        fault = ownFault(file, include->target);
    return fault;
}

struct Scan
{
    std::map<std::string, int> files; ///< by module; the rest as "widgets", "app", "app/cli"
    int includes = 0;
    std::vector<std::string> faults;
};

/** Returns a fault with its place, such as "core/plan/problem/tvp.cpp:3: fault". */
std::string located(std::string place, int line, const std::string& fault)
{
    place += ':';
    place += std::to_string(line);
    place += ": ";
    place += fault;
    return place;
}

void scanFile(const fs::path& path, const std::string& name, Scan& scan)
{
    const std::string module = moduleOf(name);
    const std::string face = name.starts_with("widgets/") ? "widgets"
                             : isOfWindow(name)           ? "app"
                                                          : "app/cli";
    ++scan.files[module.empty() ? face : module];
    std::ifstream in(path);
    std::string line;
    for (int number = 1; std::getline(in, line); ++number) {
        scan.includes += includeOf(line) ? 1 : 0;
        if (const std::string fault = faultOf(name, line); !fault.empty())
            scan.faults.push_back(located(name, number, fault));
    }
}

/** Scans every .h and .cpp below `folder` of the tree at `root`. */
void scanFolder(const fs::path& root, const std::string& folder, Scan& scan)
{
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder)) {
        const std::string extension = entry.path().extension().string();
        if (entry.is_regular_file() && (extension == ".h" || extension == ".cpp"))
            scanFile(entry.path(), fs::relative(entry.path(), root).generic_string(), scan);
    }
}

/** Returns the type or constant that `line` defines at the left margin, or an empty text. */
std::string nameGivenBy(const std::string& line)
{
    static const std::regex kType(R"(^(?:struct|class|enum class) (\w+)(?: final)?(?: : .*)?$)");
    static const std::regex kConstant(
        R"(^(?:inline )?constexpr [^(={]*\b(k[A-Z]\w*)(?:\[| =|\{).*)");
    std::smatch found;
    if (std::regex_match(line, found, kType) || std::regex_match(line, found, kConstant))
        return found[1];
    return {};
}

/** Returns the places that define types and constants, by name, in files with this extension. */
std::multimap<std::string, std::string> namesGiven(const std::string& extension)
{
    std::multimap<std::string, std::string> names;
    for (const char* folder : {"core", "app", "widgets"}) {
        for (const fs::directory_entry& entry :
             fs::recursive_directory_iterator(fs::path(BERG_SOURCE_DIR) / folder)) {
            if (entry.path().extension() != extension)
                continue;
            std::ifstream in(entry.path());
            for (std::string line; std::getline(in, line);) {
                if (std::string name = nameGivenBy(line); !name.empty())
                    names.emplace(std::move(name), entry.path().string());
            }
        }
    }
    return names;
}

} // namespace

/** Verifies that the source tree keeps to the table of layers. */
class TestLayering : public QObject
{
    Q_OBJECT

private slots:
    void includeLinesAreFound_data()
    {
        QTest::addColumn<QByteArray>("line");
        QTest::addColumn<QByteArray>("target");
        QTest::addColumn<bool>("quoted");
        const auto row = [](const char* name, const char* line, const char* target, bool quoted) {
            QTest::newRow(name) << QByteArray(line) << QByteArray(target) << quoted;
        };
        row("quoted", "#include \"core/plan/problem/tvp.h\"", "core/plan/problem/tvp.h", true);
        row("angled", "#include <QString>", "QString", false);
        row("indented, spaced", "  #  include  <vector> // why", "vector", false);
        row("no space", "#include<map>", "map", false);
        row("Windows line end", "#include <set>\r", "set", false);
        row("comment", "// #include <QString>", "", false);
        row("text", "const char* s = \"#include <QString>\";", "", false);
        row("define", "#define INCLUDE", "", false);
    }

    void includeLinesAreFound()
    {
        QFETCH(QByteArray, line);
        QFETCH(QByteArray, target);
        QFETCH(bool, quoted);
        const std::optional<Include> include = includeOf(line.toStdString());
        QCOMPARE(include.has_value(), !target.isEmpty());
        if (include) {
            QCOMPARE(include->target, target.toStdString());
            QCOMPARE(include->quoted, quoted);
        }
    }

    /** Each rule must be able to fail, as made-up good and bad lines show. */
    void rulesCatchViolations_data()
    {
        QTest::addColumn<QByteArray>("file");
        QTest::addColumn<QByteArray>("target");
        QTest::addColumn<bool>("allowed");
        const auto row = [](const char* file, const char* target, bool allowed) {
            QTest::addRow("%s %s %s", file, allowed ? "may use" : "may not use", target)
                << QByteArray(file) << QByteArray(target) << allowed;
        };
        row("core/plan/problem/tvp.cpp", "\"core/plan/problem/tvp.h\"", true);
        row("core/plan/problem/tvp.cpp", "\"core/base/error.h\"", true);
        row("core/plan/problem/tvp.cpp", "<vector>", true);
        row("core/plan/problem/tvp.cpp", "<Eigen/Core>", true);
        row("core/plan/problem/tvp.cpp", "\"core/vehicle/dubins.h\"", false);
        row("core/plan/problem/tvp.cpp", "\"core/scenario/scenario.h\"", false);
        row("core/plan/problem/tvp.cpp", "\"tvp.h\"", false);
        row("core/plan/problem/tvp.cpp", "\"../base/error.h\"", false);
        row("core/base/error.cpp", "\"core/plan/problem/tvp.h\"", false);
        row("core/vehicle/dubins.cpp", "\"core/tracking/drift.h\"", false);
        row("core/tracking/drift.h", "\"core/plan/problem/tvp.h\"", false);
        row("core/coverage/coverage_model.h", "\"core/vehicle/dubins.h\"", true);
        row("core/coverage/coverage_model.h", "\"core/sim/simulation.h\"", false);
        row("core/plan/policy/policy.h", "\"core/coverage/prediction_input.h\"", false);
        row("core/scenario/scenario.h", "\"core/tracking/drift.h\"", true);
        row("core/scenario/scenario.h", "\"core/mission/mission.h\"", false);
        row("core/mission/mission.cpp", "\"core/checks/validate.h\"", true);
        row("core/mission/mission.cpp", "\"core/study/study.h\"", false);
        row("core/mission/mission.cpp", "\"core/io/export/formats.h\"", false);
        row("core/study/study.cpp", "\"core/mission/mission.h\"", true);
        row("core/study/study.cpp", "\"core/io/export/formats.h\"", false);
        row("core/io/export/formats.cpp", "\"core/study/study.h\"", true);
        row("core/io/export/formats.cpp", "\"widgets/theme/theme.h\"", false);
        row("core/io/export/formats.cpp", "\"app/cli/commands.h\"", false);
        row("core/plan/fleet/fleet_bound.cpp", "\"core/plan/problem/tvp.h\"", true);
        row("core/plan/problem/tvp.cpp", "\"core/plan/policy/policy.h\"", false);
        row("core/io/export/maps/kml.cpp", "\"core/io/text/zip_file.h\"", true);
        row("core/io/text/json_reader.cpp", "\"core/io/files/scenario_json.h\"", false);
        row("widgets/map/view/map_view.cpp", "\"widgets/flight/asset_approach.h\"", true);
        row("widgets/map/view/map_view.cpp", "\"widgets/workspace/workspace.h\"", false);
        row("widgets/document/selection.cpp", "\"widgets/flight/flight_record.h\"", false);
        row("app/files/scenario_files.cpp", "\"app/window/menus.h\"", false);
        row("core/permit/airspace.cpp", "\"core/checks/validate.h\"", false);
        row("core/world/world.cpp", "\"core/mission/mission.h\"", false);
        row("widgets/map/view/map_view.cpp", "\"widgets/panels/plan/plan_panel.h\"", false);
        row("widgets/panels/plan/plan_panel.cpp", "\"widgets/panels/fields/number_field.h\"", true);
        row("widgets/panels/plan/plan_panel.cpp", "\"widgets/panels/study/study_panel.h\"", false);
        row("widgets/theme/theme.h", "<QColor>", true);
        row("widgets/theme/theme.h", "\"app/window/main_window.h\"", false);
        row("app/window/menus.cpp", "\"app/dialogs/interaction.h\"", true);
        row("app/dialogs/interaction.cpp", "\"app/window/menus.h\"", false);
        row("app/start/start_page.cpp", "\"widgets/theme/theme.h\"", true);
        row("core/newcomer/x.cpp", "\"core/base/error.h\"", false);
        row("core/link/message/link_frame.cpp", "\"core/base/error.h\"", true);
        row("core/link/message/link_frame.cpp", "\"core/sim/simulation.h\"", false);
        row("core/base/error.cpp", "<QString>", false);
        row("core/io/export/formats.cpp", "<QtCore/QFile>", false);
        row("core/io/export/formats.cpp", "<qtcoreexports.h>", false);
        row("core/cbc/cbc_search.cpp", "<CbcModel.hpp>", true);
        row("core/cbc/cbc_coin.h", "<OsiClpSolverInterface.hpp>", true);
        row("core/cbc/cbc_search.cpp", "\"core/plan/solve/solver.h\"", true);
        row("core/plan/solve/cbc_solver.cpp", "\"core/cbc/cbc_search.h\"", false);
        row("core/plan/solve/cbc_solver.cpp", "<CbcModel.hpp>", false);
        row("core/plan/solve/solver.cpp", "<coin/CbcModel.hpp>", false);
        row("core/io/files/problem_json.cpp", "<CoinPackedMatrix.hpp>", false);
        row("core/io/text/json_reader.cpp", "<nlohmann/json.hpp>", true);
        row("core/plan/solve/solver.cpp", "<nlohmann/json.hpp>", false);
        row("app/cli/main.cpp", "<nlohmann/json.hpp>", false);
        row("widgets/document/autosaver.cpp", "<QJsonObject>", false);
        row("core/io/text/xml_reader.cpp", "<expat.h>", true);
        row("core/io/import/fields/import_xml.cpp", "<expat.h>", false);
        row("core/io/import/forecast/netcdf_file.cpp", "<netcdf.h>", true);
        row("core/io/import/forecast/netcdf_forecast.cpp", "<netcdf.h>", false);
        row("core/io/import/forecast/grib_forecast.cpp", "<eccodes.h>", true);
        row("core/io/import/import_forecast_file.cpp", "<eccodes.h>", false);
        row("core/earth/geodesy.cpp", "<GeographicLib/Geodesic.hpp>", true);
        row("core/earth/coordinates.cpp", "<GeographicLib/DMS.hpp>", true);
        row("core/io/export/maps/gpx.cpp", "<GeographicLib/Geodesic.hpp>", false);
        row("app/cli/main.cpp", "\"core/io/export/formats.h\"", true);
        row("app/cli/main.cpp", "\"app/cli/commands.h\"", true);
        row("app/cli/main.cpp", "<CLI/CLI.hpp>", true);
        row("app/cli/main.cpp", "\"app/window/main_window.h\"", false);
        row("app/cli/main.cpp", "\"widgets/map/view/map_view.h\"", false);
        row("app/cli/main.cpp", "<QCoreApplication>", false);
    }

    void rulesCatchViolations()
    {
        QFETCH(QByteArray, file);
        QFETCH(QByteArray, target);
        QFETCH(bool, allowed);
        const std::string fault = faultOf(file.toStdString(), "#include " + target.toStdString());
        QVERIFY2(fault.empty() == allowed, fault.c_str());
    }

    /** A line that breaks a rule must be reported with file and line number. */
    void scanReportsWhere()
    {
        QTemporaryDir folder;
        QVERIFY(folder.isValid());
        const fs::path root = folder.path().toStdString();
        fs::create_directories(root / "core/plan");
        std::ofstream(root / "core/plan/bad.cpp") << "#include <vector>\n#include <QString>\n";
        std::ofstream(root / "core/plan/notes.txt") << "#include <QString>\n";
        Scan scan;
        scanFolder(root, "core", scan);
        const std::vector<std::string> expected{
            "core/plan/bad.cpp:2: Qt belongs to widgets/ and app/"};
        QVERIFY(scan.faults == expected);
        QCOMPARE(scan.files["plan"], 1);
        QCOMPARE(scan.includes, 2);
    }

    /** Each module and room may use only those that stand before it in its table. */
    void tablesHaveNoCycles()
    {
        for (const std::vector<Module>* table : {&kModules, &kRooms}) {
            std::set<std::string> before;
            for (const Module& module : *table) {
                QVERIFY2(std::includes(before.begin(), before.end(), module.mayInclude.begin(),
                                       module.mayInclude.end()),
                         module.name.c_str());
                before.insert(module.name);
            }
        }
    }

    void sourceTreeKeepsTheLayers()
    {
        Scan scan;
        scanFolder(BERG_SOURCE_DIR, "core", scan);
        scanFolder(BERG_SOURCE_DIR, "app", scan);
        scanFolder(BERG_SOURCE_DIR, "widgets", scan);
        for (const std::string& fault : scan.faults)
            qWarning("%s", fault.c_str());
        QCOMPARE(scan.faults.size(), std::size_t{0});

        // The scan has seen every module, and only modules.
        for (const Module& module : kModules)
            QVERIFY2(scan.files[module.name] > 0, module.name.c_str());
        QVERIFY(scan.files["app/cli"] > 0);
        QVERIFY(scan.files["app"] > 0);
        QVERIFY(scan.files["widgets"] > 0);
        QCOMPARE(scan.files.size(), kModules.size() + 3);
        for (const Module& room : kRooms)
            QVERIFY2(fs::is_directory(fs::path(BERG_SOURCE_DIR) / room.name), room.name.c_str());
        QVERIFY(scan.includes > 200);
    }

    void namesAreFound()
    {
        QCOMPARE(nameGivenBy("struct Drift"), "Drift");
        QCOMPARE(nameGivenBy("class AlarmStrip : public QWidget"), "AlarmStrip");
        QCOMPARE(nameGivenBy("enum class Half { Left, Right };"), "");
        QCOMPARE(nameGivenBy("class Workspace;"), "");
        QCOMPARE(nameGivenBy("inline constexpr int kRounds = 20;"), "kRounds");
        QCOMPARE(nameGivenBy("constexpr std::array<Row, 2> kRows{"), "kRows");
        QCOMPARE(nameGivenBy("constexpr double kOfMember{kRows.size()};"), "kOfMember");
        QCOMPARE(nameGivenBy("constexpr double half(double x)"), "");
        QCOMPARE(nameGivenBy("    constexpr int kWithin = 1;"), "");
    }

    /** Names must be unique, because sources may be compiled together. */
    void namesOfHeadersAreGivenOnce()
    {
        const std::multimap<std::string, std::string> inHeaders = namesGiven(".h");
        std::multimap<std::string, std::string> all = namesGiven(".cpp");
        QVERIFY(inHeaders.size() > 500 && all.size() > 500);
        all.insert(inHeaders.begin(), inHeaders.end());
        for (const auto& [name, file] : inHeaders)
            QVERIFY2(all.count(name) == 1, (name + " of " + file).c_str());
    }
};

QTEST_APPLESS_MAIN(TestLayering)
#include "tst_layering.moc"
