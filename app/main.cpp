#include "app/cli/console.h"
#include "app/cli/output_gate.h"
#include "app/export_run.h"
#include "app/pictures.h"
#include "app/settings/run_settings.h"
#include "app/window/window_run.h"
#include "core/base/error.h"
#include "core/base/version.h"
#include "widgets/manual/manual_pages.h"
#include "widgets/theme/language.h"
#include "widgets/words/error_text.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QFile>
#include <QHashSeed>
#include <QIcon>
#include <QRegularExpression>
#include <QTextStream>

#include <clocale>
#include <cstdio>

using namespace Qt::StringLiterals;

namespace {

using berg::cli::kBadInput;
using berg::cli::kDone;
using berg::cli::kFailure;
using berg::cli::kWrongUsage;

struct Main
{
    Q_DECLARE_TR_FUNCTIONS(Main)
};

/** Pictures need no screen: without one Qt must not look for it. */
void choosePlatform()
{
    const bool hasDisplay =
        qEnvironmentVariableIsSet("DISPLAY") || qEnvironmentVariableIsSet("WAYLAND_DISPLAY");
    if (!hasDisplay && !qEnvironmentVariableIsSet("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
}

/** The size that was chosen in the window, where none is given from outside; pictures have their
 * own. */
void chooseScale(int argc, char* argv[])
{
    if (qEnvironmentVariableIsSet("QT_SCALE_FACTOR"))
        return;
    QString config;
    for (int i = 1; i < argc; ++i) {
        const QString argument = QFile::decodeName(argv[i]);
        if (argument == u"--screenshot"_s || argument == u"--pictures"_s ||
            argument == u"--manual"_s || argument.startsWith(u"--screenshot="_s) ||
            argument.startsWith(u"--pictures="_s) || argument.startsWith(u"--manual="_s))
            return;
        if (argument.startsWith(u"--config="_s))
            config = argument.section(u'=', 1);
        else if (argument == u"--config"_s && i + 1 < argc)
            config = QFile::decodeName(argv[i + 1]);
    }
    const int scale_percent = berg::RunSettings::savedScale_percent(config);
    if (scale_percent != 100)
        qputenv("QT_SCALE_FACTOR", QByteArray::number(scale_percent / 100.0));
}

void print(std::FILE* stream, const QString& text)
{
    QTextStream(stream) << text << Qt::endl;
}

/** The request of the command line, or its error. */
struct Request
{
    berg::PictureOptions options;
    QString input;
    bool force = false; ///< files that exist are overwritten
    QString fault;      ///< empty if the request is valid
};

std::optional<QSize> sizeOf(const QString& text)
{
    static const QRegularExpression pattern(u"^(\\d{1,5})[xX](\\d{1,5})$"_s);
    const QRegularExpressionMatch match = pattern.match(text);
    if (!match.hasMatch())
        return std::nullopt;
    const QSize size_px(match.captured(1).toInt(), match.captured(2).toInt());
    const auto allowed = [](int side_px) {
        return side_px >= berg::kSmallestPicture_px && side_px <= berg::kLargestPicture_px;
    };
    if (!allowed(size_px.width()) || !allowed(size_px.height()))
        return std::nullopt;
    return size_px;
}

struct Options
{
    QCommandLineOption pictures{u"pictures"_s,
                                Main::tr("Write map.png, zeta.png and sigma.png of a run, or of a "
                                         "scenario's complete run, into <folder>; with --theme "
                                         "both also map-dark.png, zeta-dark.png and "
                                         "sigma-dark.png."),
                                Main::tr("folder")};
    QCommandLineOption force{u"force"_s, Main::tr("Overwrite existing files.")};
    QCommandLineOption size{
        u"size"_s,
        Main::tr("Size of each picture in pixels, e.g. 1920x1080 (default: 1600x1000 for the map, "
                 "1600x700 for the charts)."),
        Main::tr("WxH", "width x height")};
    QCommandLineOption theme{u"theme"_s,
                             Main::tr("Appearance of the pictures: light, dark or both."),
                             Main::tr("theme"), u"light"_s};
    QCommandLineOption screenshot{
        u"screenshot"_s,
        Main::tr("Write a picture of the window with the scenario to <file>, then exit."),
        Main::tr("file")};
    QCommandLineOption at{u"at"_s, Main::tr("Fly until this time before the screenshot."),
                          Main::tr("seconds"), u"0"_s};
    QCommandLineOption wait{
        u"wait"_s,
        Main::tr(
            "Longest wait before the screenshot for predictions and the lower bound, in seconds."),
        Main::tr("seconds"), u"0"_s};
    QCommandLineOption manual{
        u"manual"_s,
        Main::tr("Write the manual as web pages and as PDF into <folder>, which has its pictures."),
        Main::tr("folder")};
    QCommandLineOption config{
        u"config"_s, Main::tr("Store settings in <file> instead of your own settings file."),
        Main::tr("file")};
};

/** Returns the request for a window; a wrong option sets `fault`, as for pictures. */
berg::WindowOptions windowOptionsOf(const QCommandLineParser& parser, const Options& options,
                                    QString& fault)
{
    berg::WindowOptions window{.config = parser.value(options.config),
                               .screenshot = parser.value(options.screenshot)};
    if (parser.isSet(options.size)) {
        window.size_px = sizeOf(parser.value(options.size));
        if (!window.size_px)
            fault = Main::tr("--size: \"%1\" is not a size like 1920x1080.")
                        .arg(parser.value(options.size));
    }
    if (parser.isSet(options.theme)) {
        const QString theme = parser.value(options.theme);
        if (theme != u"light"_s && theme != u"dark"_s)
            fault = Main::tr("--theme: \"%1\" is not light or dark.").arg(theme);
        window.dark = theme == u"dark"_s;
    }
    bool isNumber = false;
    window.at_s = parser.value(options.at).toDouble(&isNumber);
    if (!isNumber || !(window.at_s >= 0))
        fault = Main::tr("--at: \"%1\" is not a number of seconds.").arg(parser.value(options.at));
    window.wait_s = parser.value(options.wait).toDouble(&isNumber);
    if (!isNumber || !(window.wait_s >= 0 && window.wait_s <= berg::kLongestScreenshotWait_s))
        fault = Main::tr("--wait: \"%1\" is not a number of seconds up to %2.")
                    .arg(parser.value(options.wait))
                    .arg(berg::kLongestScreenshotWait_s);
    const QStringList files = parser.positionalArguments();
    if (files.size() > 1)
        fault = Main::tr("Name at most one scenario file; %1 were named.").arg(files.size());
    window.scenario = files.value(0);
    return window;
}

Request requestOf(const QCommandLineParser& parser, const Options& options)
{
    Request request;
    request.options.folder = parser.value(options.pictures);
    request.force = parser.isSet(options.force);
    if (parser.isSet(options.size)) {
        request.options.size_px = sizeOf(parser.value(options.size));
        if (!request.options.size_px)
            request.fault = Main::tr("--size: \"%1\" is not a size like 1920x1080 with sides from "
                                     "%2 to %3 pixels.")
                                .arg(parser.value(options.size))
                                .arg(berg::kSmallestPicture_px)
                                .arg(berg::kLargestPicture_px);
    }
    const QString theme = parser.value(options.theme);
    if (theme == u"dark"_s)
        request.options.theme = berg::PictureTheme::Dark;
    else if (theme == u"both"_s)
        request.options.theme = berg::PictureTheme::Both;
    else if (theme != u"light"_s)
        request.fault = Main::tr("--theme: \"%1\" is not light, dark or both.").arg(theme);
    if (request.options.folder.isEmpty())
        request.fault = Main::tr("--pictures: the name of a folder is missing.");
    const QStringList files = parser.positionalArguments();
    if (files.size() != 1)
        request.fault = Main::tr("Name one run or scenario file; %1 were named.").arg(files.size());
    else
        request.input = files.front();
    return request;
}

/** Checks the outputs before any work, like the commands of bergwatch-cli. */
void checkOutputs(const QString& input, std::vector<berg::cli::Output> outputs, bool force)
{
    std::vector<std::string> inputs;
    if (!input.isEmpty())
        inputs.push_back(QFile::encodeName(input).toStdString());
    berg::cli::checkFiles({.inputs = inputs, .outputs = std::move(outputs), .force = force});
}

void makePictures(const Request& request)
{
    std::vector<std::string> names;
    for (const QString& name : berg::pictureNames(request.options.theme))
        names.push_back(name.toStdString());
    const std::string folder = QFile::encodeName(request.options.folder).toStdString();
    checkOutputs(request.input,
                 berg::cli::outputsIn("--pictures", folder,
                                      std::vector<std::string_view>(names.begin(), names.end())),
                 request.force);
    const berg::Mission mission =
        berg::flownMission(QFile::encodeName(request.input).toStdString());
    for (const QString& path : berg::writePictures(mission, request.options, QLocale()))
        print(stdout, path);
}

void makeManual(const QString& folder, bool force)
{
    std::vector<std::string> names;
    for (const QString& name : berg::manualFileNames())
        names.push_back(name.toStdString());
    checkOutputs({},
                 berg::cli::outputsIn("--manual", QFile::encodeName(folder).toStdString(),
                                      std::vector<std::string_view>(names.begin(), names.end())),
                 force);
    for (const QString& path : berg::writeManual(folder))
        print(stdout, path);
}

void checkScreenshot(const berg::WindowOptions& window, bool force)
{
    checkOutputs(
        window.scenario,
        {{.option = "--screenshot", .path = QFile::encodeName(window.screenshot).toStdString()}},
        force);
}

/** Returns the exit code of `work` and reports its exceptions. */
template <class Work>
int exitCodeOf(const Work& work)
{
    try {
        work();
        return kDone;
    } catch (const berg::cli::UsageError& error) {
        berg::cli::printMessage(error.message.said);
        return kWrongUsage;
    } catch (const berg::Error& error) {
        print(stderr, berg::errorReport(error));
        return error.code() == berg::ErrorCode::FileUnwritable ? kFailure : kBadInput;
    } catch (const std::bad_alloc&) {
        print(stderr, Main::tr("There is not enough memory."));
        return kFailure;
    } catch (const std::exception& error) {
        print(stderr, Main::tr("Bergwatch has crashed: %1").arg(QString::fromUtf8(error.what())));
        return kFailure;
    }
}

} // namespace

int main(int argc, char* argv[])
{
    // A PDF has its fonts in the order of a hash: so that the same page is the same bytes.
    QHashSeed::setDeterministicGlobalSeed();
    if (berg::asksForExport(argc, argv))
        return berg::runExport(argc, argv);
    choosePlatform();
    chooseScale(argc, argv);
    QApplication app(argc, argv);
    // NOLINTNEXTLINE(concurrency-mt-unsafe): no other thread yet
    std::setlocale(LC_NUMERIC, "C"); // which the constructor set to the user's; files are in C
    QApplication::setApplicationName(u"bergwatch"_s);
    QApplication::setApplicationVersion(QString::fromStdString(berg::programVersion()));
    QApplication::setDesktopFileName(u"org.bergwatch.bergwatch"_s);
    QApplication::setWindowIcon(QIcon(u":/icon/bergwatch.svg"_s));
    berg::installLanguage(std::nullopt);

    const Options options;
    QCommandLineParser parser;
    parser.setApplicationDescription(
        Main::tr("Opens the window with a scenario; with --pictures it only writes pictures.") +
        u"\n\n"_s +
        Main::tr("The command \"export\" writes plans and flights as files, maps, charts and "
                 "briefs: see \"bergwatch export --help\"."));
    const QCommandLineOption help = parser.addHelpOption();
    const QCommandLineOption version = parser.addVersionOption();
    parser.addOptions({options.pictures, options.force, options.size, options.theme,
                       options.screenshot, options.at, options.wait, options.manual,
                       options.config});
    parser.addPositionalArgument(
        Main::tr("file"),
        Main::tr("A scenario (.berg), run (.bergrun), study (.bergstudy) or telemetry log "
                 "(.tlog)."));
    if (!parser.parse(QApplication::arguments())) {
        print(stderr, parser.errorText());
        return kWrongUsage;
    }
    if (parser.isSet(version)) {
        print(stdout, u"bergwatch "_s + QApplication::applicationVersion());
        return kDone;
    }
    if (parser.isSet(help)) {
        print(stdout, parser.helpText());
        return kDone;
    }
    if (parser.isSet(u"help-all"_s))               // which Qt adds with --help
        parser.process(QApplication::arguments()); // prints it, and ends
    if (parser.isSet(options.manual)) {
        if (parser.isSet(options.pictures) || parser.isSet(options.screenshot) ||
            !parser.positionalArguments().isEmpty()) {
            print(stderr, Main::tr("--manual takes no scenario file, --pictures or --screenshot."));
            return kWrongUsage;
        }
        return exitCodeOf(
            [&] { makeManual(parser.value(options.manual), parser.isSet(options.force)); });
    }
    if (!parser.isSet(options.pictures)) {
        QString fault;
        const berg::WindowOptions window = windowOptionsOf(parser, options, fault);
        if (!fault.isEmpty()) {
            print(stderr, fault);
            return kWrongUsage;
        }
        const int code = exitCodeOf([&] { checkScreenshot(window, parser.isSet(options.force)); });
        return code == kDone ? berg::runWindow(window) : code;
    }
    const Request request = requestOf(parser, options);
    if (!request.fault.isEmpty()) {
        print(stderr, request.fault);
        return kWrongUsage;
    }
    return exitCodeOf([&] { makePictures(request); });
}
