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

namespace {

namespace fs = std::filesystem;

/** A module of the core and the other modules its files may include. */
struct Module
{
    std::string name;
    std::set<std::string> mayInclude;
};

// The table of ARCHITECTURE.md, section 1. Siblings on level 2 never include each other.
const std::vector<Module> kModules{
    {"base", {}},
    {"plan", {"base"}},
    {"vehicle", {"base"}},
    {"tracking", {"base"}},
    {"coverage", {"base", "plan", "vehicle", "tracking"}},
    {"scenario", {"base", "plan", "vehicle", "tracking"}},
    {"bound", {"base", "plan", "vehicle", "tracking", "scenario"}},
    {"sim", {"base", "plan", "vehicle", "tracking", "coverage", "scenario"}},
    {"study", {"base", "plan", "vehicle", "tracking", "coverage", "scenario", "sim"}},
    {"io", {"base", "plan", "vehicle", "tracking", "coverage", "scenario", "sim", "study"}},
};

struct Include
{
    std::string target;
    bool quoted = false; ///< "..." rather than <...>
};

/** The include of a source line, none when it is another line (or a comment). */
std::optional<Include> includeOf(const std::string& line)
{
    static const std::regex pattern(R"(^\s*#\s*include\s*([<"])([^">]+)[">])");
    std::smatch match;
    if (!std::regex_search(line, match, pattern))
        return std::nullopt;
    return Include{.target = match[2], .quoted = match[1] == "\""};
}

/** `core/plan/tvp.h` -> `plan`; empty for what is not below core/. */
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

/** What is wrong with a third-party header in this file; empty when nothing is. */
std::string thirdPartyFault(const std::string& file, const std::string& target)
{
    if (target.starts_with('Q') || target.starts_with("qt") || target.starts_with("ui_"))
        return "Qt belongs to widgets/ and app/";
    if (startsWithAny(target, {"Cbc", "Cgl", "Coin", "Clp", "Osi", "coin/"}) &&
        !startsWithAny(
            file, {"core/plan/cbc_solver.cpp", "core/plan/cbc_cover.cpp", "core/plan/cbc_coin.h"}))
        return "COIN belongs to core/plan/cbc_solver, cbc_cover and cbc_coin";
    if (target.starts_with("nlohmann") && moduleOf(file) != "io")
        return "JSON belongs to core/io";
    if (target == "expat.h" && file != "core/io/xml_reader.cpp")
        return "Expat belongs to core/io/xml_reader.cpp";
    if (target.starts_with("GeographicLib") &&
        !startsWithAny(file, {"core/base/geodesy.", "core/base/coordinates."}))
        return "GeographicLib belongs to core/base/geodesy and coordinates";
    return {};
}

/** What is wrong with an include of our own; empty when nothing is. */
std::string ownFault(const std::string& file, const std::string& target)
{
    const std::string from = moduleOf(file);
    const std::string to = moduleOf(target);
    if (from.empty()) // the command line
        return target.starts_with("core/") || target.starts_with("app/cli/")
                   ? ""
                   : "the command line uses the core only";
    if (to.empty())
        return "below core/, includes are root-relative and stay in core/";
    const auto module = std::find_if(kModules.begin(), kModules.end(),
                                     [&](const Module& m) { return m.name == from; });
    if (module == kModules.end())
        return "module " + from + " is not in the table of layers";
    return to == from || module->mayInclude.contains(to) ? "" : from + " may not use " + to;
}

/** Faults of one line of `file` (path from the root of the project); empty when there are none. */
std::string faultOf(const std::string& file, const std::string& line)
{
    const std::optional<Include> include = includeOf(line);
    if (!include)
        return {};
    std::string fault = thirdPartyFault(file, include->target);
    if (fault.empty() && include->quoted)
        fault = ownFault(file, include->target);
    return fault;
}

struct Scan
{
    std::map<std::string, int> files; ///< by module; the command line under "app/cli"
    int includes = 0;
    std::vector<std::string> faults;
};

/** "core/plan/tvp.cpp:3: fault". */
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
    ++scan.files[module.empty() ? "app/cli" : module];
    std::ifstream in(path);
    std::string line;
    for (int number = 1; std::getline(in, line); ++number) {
        scan.includes += includeOf(line) ? 1 : 0;
        if (const std::string fault = faultOf(name, line); !fault.empty())
            scan.faults.push_back(located(name, number, fault));
    }
}

/** Every .h and .cpp below `folder` of the tree at `root`. */
void scanFolder(const fs::path& root, const std::string& folder, Scan& scan)
{
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder)) {
        const std::string extension = entry.path().extension().string();
        if (entry.is_regular_file() && (extension == ".h" || extension == ".cpp"))
            scanFile(entry.path(), fs::relative(entry.path(), root).generic_string(), scan);
    }
}

} // namespace

/** Holds the source tree to the table of layers. */
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
        row("quoted", "#include \"core/plan/tvp.h\"", "core/plan/tvp.h", true);
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

    /** Each rule must be able to fail: made-up lines, good and bad. */
    void rulesCatchViolations_data()
    {
        QTest::addColumn<QByteArray>("file");
        QTest::addColumn<QByteArray>("target");
        QTest::addColumn<bool>("allowed");
        const auto row = [](const char* file, const char* target, bool allowed) {
            QTest::addRow("%s %s %s", file, allowed ? "may use" : "may not use", target)
                << QByteArray(file) << QByteArray(target) << allowed;
        };
        row("core/plan/tvp.cpp", "\"core/plan/tvp.h\"", true);
        row("core/plan/tvp.cpp", "\"core/base/error.h\"", true);
        row("core/plan/tvp.cpp", "<vector>", true);
        row("core/plan/tvp.cpp", "<Eigen/Core>", true);
        row("core/plan/tvp.cpp", "\"core/vehicle/dubins.h\"", false);
        row("core/plan/tvp.cpp", "\"core/scenario/scenario.h\"", false);
        row("core/plan/tvp.cpp", "\"tvp.h\"", false);
        row("core/plan/tvp.cpp", "\"../base/error.h\"", false);
        row("core/base/error.cpp", "\"core/plan/tvp.h\"", false);
        row("core/vehicle/dubins.cpp", "\"core/tracking/drift.h\"", false);
        row("core/tracking/drift.h", "\"core/plan/tvp.h\"", false);
        row("core/coverage/coverage_model.h", "\"core/vehicle/dubins.h\"", true);
        row("core/coverage/coverage_model.h", "\"core/sim/simulation.h\"", false);
        row("core/plan/policy.h", "\"core/coverage/flight_picture.h\"", false);
        row("core/scenario/scenario.h", "\"core/tracking/drift.h\"", true);
        row("core/scenario/scenario.h", "\"core/sim/mission.h\"", false);
        row("core/sim/mission.cpp", "\"core/scenario/validate.h\"", true);
        row("core/sim/mission.cpp", "\"core/study/study.h\"", false);
        row("core/sim/mission.cpp", "\"core/io/formats.h\"", false);
        row("core/study/study.cpp", "\"core/sim/mission.h\"", true);
        row("core/study/study.cpp", "\"core/io/formats.h\"", false);
        row("core/io/formats.cpp", "\"core/study/study.h\"", true);
        row("core/io/formats.cpp", "\"widgets/theme/theme.h\"", false);
        row("core/io/formats.cpp", "\"app/cli/commands.h\"", false);
        row("core/newcomer/x.cpp", "\"core/base/error.h\"", false);
        row("core/base/error.cpp", "<QString>", false);
        row("core/io/formats.cpp", "<QtCore/QFile>", false);
        row("core/io/formats.cpp", "<qtcoreexports.h>", false);
        row("core/plan/cbc_solver.cpp", "<CbcModel.hpp>", true);
        row("core/plan/cbc_solver.cpp", "<OsiClpSolverInterface.hpp>", true);
        row("core/plan/cbc_solver.h", "<CbcModel.hpp>", false);
        row("core/plan/solver.cpp", "<coin/CbcModel.hpp>", false);
        row("core/io/problem_json.cpp", "<CoinPackedMatrix.hpp>", false);
        row("core/io/json_reader.cpp", "<nlohmann/json.hpp>", true);
        row("core/plan/solver.cpp", "<nlohmann/json.hpp>", false);
        row("app/cli/main.cpp", "<nlohmann/json.hpp>", false);
        row("core/io/xml_reader.cpp", "<expat.h>", true);
        row("core/io/import_xml.cpp", "<expat.h>", false);
        row("core/base/geodesy.cpp", "<GeographicLib/Geodesic.hpp>", true);
        row("core/base/coordinates.cpp", "<GeographicLib/DMS.hpp>", true);
        row("core/io/gpx.cpp", "<GeographicLib/Geodesic.hpp>", false);
        row("app/cli/main.cpp", "\"core/io/formats.h\"", true);
        row("app/cli/main.cpp", "\"app/cli/commands.h\"", true);
        row("app/cli/main.cpp", "<CLI/CLI.hpp>", true);
        row("app/cli/main.cpp", "\"app/main_window.h\"", false);
        row("app/cli/main.cpp", "\"widgets/map/map_view.h\"", false);
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

    void tableHasNoCycles()
    {
        // Each module may use only such as stand before it in the table.
        std::set<std::string> before;
        for (const Module& module : kModules) {
            QVERIFY2(std::includes(before.begin(), before.end(), module.mayInclude.begin(),
                                   module.mayInclude.end()),
                     module.name.c_str());
            before.insert(module.name);
        }
    }

    void sourceTreeKeepsTheLayers()
    {
        Scan scan;
        scanFolder(BERG_SOURCE_DIR, "core", scan);
        scanFolder(BERG_SOURCE_DIR, "app/cli", scan);
        for (const std::string& fault : scan.faults)
            qWarning("%s", fault.c_str());
        QCOMPARE(scan.faults.size(), std::size_t{0});

        // The scan has really seen the tree: every module, and nothing but modules.
        for (const Module& module : kModules)
            QVERIFY2(scan.files[module.name] > 0, module.name.c_str());
        QVERIFY(scan.files["app/cli"] > 0);
        QCOMPARE(scan.files.size(), kModules.size() + 1);
        QVERIFY(scan.includes > 200);
    }
};

QTEST_APPLESS_MAIN(TestLayering)
#include "tst_layering.moc"
