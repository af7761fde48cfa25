#include "app/window/window_run.h"

#include "app/cli/console.h"
#include "app/dialogs/screen_fit.h"
#include "app/files/scenario_files.h"
#include "app/files/start_page_controller.h"
#include "app/settings/run_settings.h"
#include "app/window/main_window_host.h"
#include "app/window/window_parts.h"
#include "core/io/text/atomic_file.h"
#include "core/presets/presets.h"
#include "widgets/map/view/map_view.h"
#include "widgets/theme/accessible_roles.h"
#include "widgets/theme/language.h"
#include "widgets/words/error_text.h"
#include "widgets/workspace/workspace.h"

#include <QApplication>
#include <QBuffer>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTextStream>

#include <cstdio>

using namespace Qt::StringLiterals;

namespace berg {

namespace {

void say(const QString& text)
{
    QTextStream(stderr) << text << Qt::endl;
}

void saveImage(const QPixmap& pixmap, const QString& path)
{
    QByteArray png;
    QBuffer buffer(&png);
    buffer.open(QIODevice::WriteOnly);
    pixmap.save(&buffer, "PNG");
    writeFileAtomically(QFile::encodeName(path).toStdString(),
                        {png.constData(), static_cast<std::size_t>(png.size())});
}

/** Flies to the time asked for, then renders the window and ends the program. */
void arrangeScreenshot(Workspace& workspace, MainWindow& window, const WindowOptions& options)
{
    const auto done = [&window, path = options.screenshot] {
        int code = 0;
        try {
            window.grab(); // requests the land it needs
            window.finishLand();
            saveImage(window.grab(), path);
        } catch (const Error& error) {
            say(errorReport(error));
            code = 1;
        }
        QApplication::exit(code);
    };
    const auto whenPredicted = [&window, &workspace, done,
                                wait_ms = static_cast<int>(1000 * options.wait_s)] {
        constexpr int kUntilDrawn_ms = 1000;
        const auto isPredicted = [&workspace] {
            return workspace.forecasts().isComplete() && workspace.bound().isComplete();
        };
        if (wait_ms == 0 || isPredicted()) {
            done();
            return;
        }
        QTimer::singleShot(wait_ms, &window, done);
        const auto check = [&window, isPredicted, done] {
            if (isPredicted())
                QTimer::singleShot(kUntilDrawn_ms, &window, done);
        };
        QObject::connect(&workspace.forecasts(), &PolicyForecasts::updated, &window, check);
        QObject::connect(&workspace.bound(), &BoundRunner::updated, &window, check);
    };
    const auto onFlight = [&workspace, &window, whenPredicted, at_s = options.at_s,
                           asked = false]() mutable {
        const MissionSnapshot& now = workspace.record().now;
        if (now.phase == RunPhase::Planning)
            return;
        if (!asked && now.phase == RunPhase::Ready && at_s > 0) {
            asked = true;
            workspace.runner().stepBy(at_s);
            return;
        }
        // Charts are drawn a moment after the map; wait for them.
        QTimer::singleShot(300, &window, whenPredicted);
    };
    QObject::connect(&workspace, &Workspace::flightChanged, &window, onFlight);
}

void keepSafe(Workspace& workspace, const QDir& data)
{
    workspace.file().setLockFolder(data.filePath(u"locks"_s));
    workspace.autosaver().start(data.filePath(u"recovery"_s));
    workspace.studyAutosaver().start(data.filePath(u"studies"_s));
}

/** Result of opening the file on the command line, before the window exists. */
struct NamedFile
{
    QString path;       ///< empty if no file was named
    bool later = false; ///< to be opened by the window: a study, run or log, or a file in use
    QString fault = {}; ///< reason that it was not opened; empty on success
};

NamedFile openNamed(Workspace& workspace, const QString& name, bool isScreenshot)
{
    // The next start, after a crash, may be in another folder.
    const QString path = name.isEmpty() ? name : QFileInfo(name).absoluteFilePath();
    const bool later = !isScreenshot &&
                       (ScenarioFiles::isStudyFile(path) || ScenarioFiles::isRunFile(path) ||
                        ScenarioFiles::isTelemetryLog(path) || workspace.file().otherHolder(path));
    NamedFile named{.path = path, .later = later};
    if (path.isEmpty() || named.later)
        return named;
    try {
        workspace.openFile(path);
    } catch (const Error& error) {
        named.fault = errorReport(error);
    }
    return named;
}

/** Questions and messages to show after the window has opened. */
void greet(MainWindow& window, Interaction& interaction, const QSettings& settings,
           const NamedFile& file)
{
    const bool isOpen = !file.path.isEmpty() && file.fault.isEmpty();
    const bool isShown = file.later ? window.parts().files.openFile(file.path) : isOpen;
    if (!isShown && StartPageController::wantsStartPage(settings))
        window.parts().start.showPage();
    if (!file.fault.isEmpty())
        interaction.showError(&window, file.fault);
    window.parts().safety.offerRecoveries();
}

/** Gives the window the size asked for, else the one it was left with, else that of the design. */
void giveSize(MainWindow& window, const std::optional<QSize>& size_px, bool wasLeft)
{
    constexpr QSize kDesigned_px(1280, 800);
    if (size_px || !wasLeft)
        window.resize(size_px.value_or(kDesigned_px));
}

} // namespace

int runWindow(const WindowOptions& options)
{
    const bool isScreenshot = !options.screenshot.isEmpty();
    RunSettings own(options.config, isScreenshot);
    QSettings& settings = own.settings();
    if (const QString language = settings.value("view/language").toString(); !language.isEmpty())
        installLanguage(language);

    installAccessibleRoles();
    Workspace workspace;
    DialogInteraction interaction(&settings);
    workspace.document().reset(defaultScenario());
    if (!isScreenshot)
        keepSafe(workspace, QDir(own.dataFolder()));
    const NamedFile named = openNamed(workspace, options.scenario, isScreenshot);
    if (!named.fault.isEmpty())
        say(named.fault);
    if (isScreenshot && !named.fault.isEmpty())
        return cli::kBadInput;
    MainWindowHost holder(workspace, interaction, settings);
    MainWindow& window = holder.window();
    if (!isScreenshot && !settings.contains(u"window/state"_s))
        window.parts().docks.begin(Layout::Plan);
    // The layout may ask for more room than the window was given.
    giveSize(window, options.size_px, !isScreenshot && settings.contains(u"window/geometry"_s));
    if (!options.size_px && !isScreenshot)
        keepOnScreen(window);
    if (options.dark)
        window.parts().appearance.applyTheme(*options.dark ? Theme::dark() : Theme::light());
    if (isScreenshot)
        arrangeScreenshot(workspace, window, options);
    window.show();
    if (!isScreenshot)
        QTimer::singleShot(0, &window, [&] { greet(window, interaction, settings, named); });
    return QApplication::exec();
}

} // namespace berg
