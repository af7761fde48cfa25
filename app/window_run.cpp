#include "app/window_run.h"

#include "app/window_holder.h"
#include "core/io/atomic_file.h"
#include "core/scenario/presets.h"
#include "widgets/map/map_view.h"
#include "widgets/model/error_text.h"

#include <QApplication>
#include <QBuffer>
#include <QDir>
#include <QFile>
#include <QLibraryInfo>
#include <QStandardPaths>
#include <QTextStream>
#include <QTranslator>

#include <cstdio>

using namespace Qt::StringLiterals;

namespace berg {

namespace {

constexpr int kBadInput = 3;

void say(const QString& text)
{
    QTextStream(stderr) << text << Qt::endl;
}

/** Where unsaved work and locks are kept; with settings of their own, beside those. */
QString dataFolder(const QString& config)
{
    return config.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::AppDataLocation)
                            : config + u".data"_s;
}

void saveImage(const QPixmap& picture, const QString& path)
{
    QByteArray png;
    QBuffer buffer(&png);
    buffer.open(QIODevice::WriteOnly);
    picture.save(&buffer, "PNG");
    writeFileAtomically(QFile::encodeName(path).toStdString(),
                        {png.constData(), static_cast<std::size_t>(png.size())});
}

/** Flies to the time asked for, then renders the window and ends the program. */
void arrangeScreenshot(Workspace& workspace, MainWindow& window, const WindowOptions& options)
{
    const auto done = [&window, path = options.screenshot] {
        int code = 0;
        try {
            window.grab(); // tells what land it needs
            window.finishLand();
            saveImage(window.grab(), path);
        } catch (const Error& error) {
            say(errorReport(error));
            code = 1;
        }
        QApplication::exit(code);
    };
    const auto whenPredicted = [&window, &workspace, done] {
        constexpr int kLongestWait_ms = 30000;
        constexpr int kUntilDrawn_ms = 300;
        const auto isPredicted = [&workspace] {
            return workspace.forecasts().isComplete() && workspace.bound().isComplete();
        };
        if (isPredicted()) {
            done();
            return;
        }
        QTimer::singleShot(kLongestWait_ms, &window, done);
        const auto look = [&window, isPredicted, done] {
            if (isPredicted())
                QTimer::singleShot(kUntilDrawn_ms, &window, done);
        };
        QObject::connect(&workspace.forecasts(), &PolicyForecasts::updated, &window, look);
        QObject::connect(&workspace.bound(), &BoundRunner::updated, &window, look);
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
        // Charts are drawn a moment after the picture; wait for them.
        QTimer::singleShot(300, &window, whenPredicted);
    };
    QObject::connect(&workspace, &Workspace::flightChanged, &window, onFlight);
}

void keepSafe(Workspace& workspace, const QString& config)
{
    const QDir data(dataFolder(config));
    workspace.file().setLockFolder(data.filePath(u"locks"_s));
    workspace.autosaver().start(data.filePath(u"recovery"_s));
}

/** What is there to be asked or shown once the window stands; `inUse`: `file` is not open yet. */
void greet(MainWindow& window, const QSettings& settings, const QString& file, bool inUse)
{
    if (inUse)
        window.openFile(file);
    else if (file.isEmpty() && MainWindow::wantsStartPage(settings))
        window.showStartPage();
    window.offerRecoveries();
}

} // namespace

void installLanguage(const QString& language)
{
    static QTranslator own;
    static QTranslator qt;
    QCoreApplication::removeTranslator(&own);
    QCoreApplication::removeTranslator(&qt);
    const QLocale locale = language.isEmpty() ? QLocale::system() : QLocale(language);
    QLocale::setDefault(locale);
    if (own.load(locale, u"bergwatch"_s, u"_"_s, u":/i18n"_s))
        QCoreApplication::installTranslator(&own);
    if (qt.load(locale, u"qtbase"_s, u"_"_s, QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        QCoreApplication::installTranslator(&qt);
}

int runWindow(const WindowOptions& options)
{
    const bool picture = !options.screenshot.isEmpty();
    // A screenshot shows the program as it comes, whatever the user has chosen for himself.
    QSettings settings = options.config.isEmpty() && !picture
                             ? QSettings(u"Bergwatch"_s, u"bergwatch"_s)
                             : QSettings(options.config.isEmpty() ? u"/dev/null"_s : options.config,
                                         QSettings::IniFormat);
    if (const QString language = settings.value("view/language").toString(); !language.isEmpty())
        installLanguage(language);

    Workspace workspace;
    DialogInteraction interaction;
    workspace.document().reset(defaultScenario());
    if (!picture)
        keepSafe(workspace, options.config);
    const bool inUse = workspace.file().otherHolder(options.scenario).has_value();
    if (!options.scenario.isEmpty() && !inUse) {
        try {
            workspace.openFile(options.scenario);
        } catch (const Error& error) {
            say(errorReport(error));
            return kBadInput;
        }
    }
    WindowHolder holder(workspace, interaction, settings);
    MainWindow& window = holder.window();
    window.resize(options.size_px);
    if (options.dark)
        window.applyTheme(*options.dark ? Theme::dark() : Theme::light());
    if (picture)
        arrangeScreenshot(workspace, window, options);
    window.show();
    if (!picture)
        QTimer::singleShot(0, &window, [&window, &settings, &options, inUse] {
            greet(window, settings, options.scenario, inUse);
        });
    return QApplication::exec();
}

} // namespace berg
