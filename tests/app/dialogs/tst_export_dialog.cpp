#include "app/dialogs/export_dialog.h"
#include "app/dialogs/export_options_view.h"
#include "core/io/text/atomic_file.h"
#include "core/presets/presets.h"
#include "tests/support/approx.h"
#include "tests/support/window/window_fixture.h"
#include "widgets/panels/fields/number_field.h"
#include "widgets/print/export_painter.h"
#include "widgets/theme/unit_settings.h"
#include "widgets/words/export_text.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTableView>

using namespace berg;
using namespace Qt::StringLiterals;
using test::child;

namespace {

Scenario withUavs(int count)
{
    Scenario scenario = randomScenario(31, {.icebergs = 4});
    while (static_cast<int>(scenario.uavs.size()) < count) {
        Uav next = scenario.uavs.front();
        next.id = "uav-" + std::to_string(scenario.uavs.size() + 1);
        next.position_m += Point(900.0 * static_cast<double>(scenario.uavs.size()), 0);
        scenario.uavs.push_back(next);
    }
    return scenario;
}

/** The dialog on a mission of its own. */
class Exporting
{
public:
    explicit Exporting(const Scenario& scenario, const ExportRequest& suggested = {},
                       double flown_s = 0, const Theme& theme = Theme::light())
    {
        m_runner.setExportPaint(exportPaint());
        m_runner.setScenario(scenario);
        if (flown_s > 0)
            m_runner.stepBy(flown_s);
        ExportOffer offer{.suggested = suggested,
                          .flown = flown_s > 0,
                          .scenario = std::make_shared<const Scenario>(scenario),
                          .theme = theme};
        if (offer.suggested.path.isEmpty())
            offer.suggested.path = folder.filePath(u"survey"_s);
        m_dialog = std::make_unique<ExportDialog>(m_runner, offer);
        m_dialog->show();
    }

    QTemporaryDir folder;

    [[nodiscard]] ExportDialog& dialog() { return *m_dialog; }
    [[nodiscard]] ExportRequest choice() { return m_dialog->choice(); }
    template <class Widget>
    [[nodiscard]] Widget& at(const char* name)
    {
        return child<Widget>(*m_dialog, QString::fromLatin1(name));
    }
    [[nodiscard]] bool canExport() { return at<QPushButton>("exportButton").isEnabled(); }
    [[nodiscard]] bool settles()
    {
        const auto& note = at<QLabel>("exportFileNote");
        return QTest::qWaitFor([&] { return canExport() && note.text() != u"Working ..."_s; },
                               60000);
    }
    [[nodiscard]] bool isRefused()
    {
        return QTest::qWaitFor([this] { return notes().contains(u"Not possible"_s); }, 60000);
    }
    [[nodiscard]] QString notes() { return at<QLabel>("exportNotes").text(); }
    [[nodiscard]] QStringList formats()
    {
        QStringList ids;
        auto& list = at<QListWidget>("formatList");
        for (int row = 0; row < list.count(); ++row)
            if (const QVariant id = list.item(row)->data(Qt::UserRole); id.isValid())
                ids << id.toString();
        return ids;
    }
    void choose(const QString& format)
    {
        auto& list = at<QListWidget>("formatList");
        for (int row = 0; row < list.count(); ++row)
            if (list.item(row)->data(Qt::UserRole).toString() == format)
                list.setCurrentRow(row);
    }
    /** Returns the request that the dialog would export. */
    [[nodiscard]] std::vector<ExportFile> written()
    {
        std::vector<ExportFile> taken;
        QObject context;
        QObject::connect(&m_runner, &MissionRunner::exportReady, &context,
                         [&](const std::vector<ExportFile>& files) { taken = files; });
        m_runner.requestExport(m_dialog->choice());
        if (!QTest::qWaitFor([&] { return !taken.empty(); }, 60000))
            qFatal("nothing is written");
        return taken;
    }

private:
    MissionRunner m_runner;
    std::unique_ptr<ExportDialog> m_dialog;
};

} // namespace

/** Exporting: the dialog by itself. */
class TestExportDialog : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void offersWhatThereIs()
    {
        Exporting plan(withUavs(1));
        Exporting flight(withUavs(1), {}, 20);
        for (const ExportFormat& format : exportFormats()) {
            const QString id = QString::fromStdString(std::string(format.id));
            QCOMPARE(plan.formats().contains(id), !format.holds.flownOnly);
            QVERIFY(flight.formats().contains(id));
        }
        QCOMPARE(plan.at<QComboBox>("exportWhat").count(), 3);
        QCOMPARE(flight.at<QComboBox>("exportWhat").count(), 4);
        QVERIFY(plan.at<QComboBox>("exportUav").isHidden());
    }

    void previewIsWhatIsWritten_data()
    {
        QTest::addColumn<QString>("format");
        for (const char* format : {"plan", "wpl", "geojson", "csv", "gpx", "kml", "czml"})
            QTest::newRow(format) << QString::fromLatin1(format);
    }

    void previewIsWhatIsWritten()
    {
        QFETCH(QString, format);
        Exporting dialog(withUavs(2));
        dialog.choose(format);
        QVERIFY(dialog.settles());
        QString shown = dialog.at<QPlainTextEdit>("exportText").toPlainText();
        const std::vector<ExportFile> files = dialog.written();
        QString whole = QString::fromStdString(files.front().content);
        if (shown.endsWith(u'…'))
            shown.chop(2);
        QVERIFY(shown.size() > 100);
        // A text field knows one kind of line end.
        QVERIFY(whole.remove(u'\r').startsWith(shown));
        for (const ExportFile& file : files)
            QVERIFY(dialog.at<QLabel>("exportFileNote")
                        .text()
                        .contains(QFileInfo(QString::fromStdString(file.path)).fileName()));
    }

    void pagesAreShownAsTheyAreWritten_data()
    {
        QTest::addColumn<QString>("format");
        QTest::addColumn<QByteArray>("head");
        for (const ExportFormat& format : exportFormats()) {
            const QByteArray head = format.extension == "pdf"   ? "%PDF"
                                    : format.extension == "png" ? "\x89PNG"
                                                                : "<?xml";
            if (format.holds.painted)
                QTest::addRow("%s", std::string(format.id).c_str())
                    << QString::fromStdString(std::string(format.id)) << head;
        }
    }

    void pagesAreShownAsTheyAreWritten()
    {
        QFETCH(QString, format);
        QFETCH(QByteArray, head);
        Exporting dialog(withUavs(2), {}, 60);
        QVERIFY(dialog.settles());
        QVERIFY(!dialog.at<QWidget>("exportPage").isVisible());
        dialog.choose(format);
        QVERIFY(dialog.settles());
        QVERIFY(dialog.at<QWidget>("exportPage").isVisible());
        QVERIFY(!dialog.at<QPlainTextEdit>("exportText").isVisible());
        const QImage shown = dialog.at<QWidget>("exportPage").grab().toImage();
        QSet<QRgb> colours;
        for (int y = 0; y < shown.height(); y += 3)
            for (int x = 0; x < shown.width(); x += 3)
                colours << shown.pixel(x, y);
        QVERIFY(colours.size() > 10);
        const QWidget& page = dialog.at<QWidget>("exportPage");
        const bool isScrolled = !format.startsWith(u"map"_s);
        QTRY_COMPARE(page.height() > page.parentWidget()->height(), isScrolled);
        const std::vector<ExportFile> files = dialog.written();
        QCOMPARE(files.size(), 1U);
        QVERIFY(files.front().content.starts_with(head.toStdString()));
        dialog.choose(u"gpx"_s);
        QVERIFY(dialog.settles());
        QVERIFY(!dialog.at<QWidget>("exportPage").isVisible());
        QVERIFY(dialog.at<QWidget>("exportMap").isVisible());
    }

    void pagesAreOnRedPaperAtNight()
    {
        const Theme night = Theme::night();
        Exporting dialog(withUavs(1), {}, 0, night);
        QVERIFY(dialog.settles());
        dialog.choose(u"brief"_s);
        QVERIFY(dialog.settles());
        QWidget& view = dialog.at<QWidget>("exportPage");
        QTRY_VERIFY(view.height() > view.parentWidget()->height()); // as wide as there is room
        const QImage shown = view.grab().toImage();
        const QRect page = shown.rect().adjusted(40, 40, -40, -shown.height() / 2);
        QVERIFY(page.height() > 40);
        for (int y = page.top(); y < page.bottom(); ++y)
            for (int x = page.left(); x < page.right(); ++x) {
                const QColor colour = shown.pixelColor(x, y);
                QVERIFY(colour.red() <= night.mutedText.red());
                QVERIFY(colour.blue() <= night.mutedText.blue());
            }
    }

    void speedIsInTheUnitOfTheUser()
    {
        setShownUnits({.speed = SpeedUnit::Knots});
        const auto back = qScopeGuard([] { setShownUnits({}); });
        Exporting dialog(withUavs(1), {.formatId = "plan", .options = {.airspeed_mps = 18.52}});
        auto& airspeed = dialog.at<NumberField>("exportAirspeed");
        QCOMPARE(airspeed.value(), 36);
        QVERIFY(airspeed.text().endsWith(u"kn"_s));
        airspeed.setValue(45);
        COMPARE_NEAR(dialog.choice().options.airspeed_mps.value_or(0), 23.15, 1e-9);
    }

    void newestChoiceIsShown()
    {
        Exporting dialog(withUavs(1));
        for (const QString& format : dialog.formats())
            dialog.choose(format);
        dialog.choose(u"gpx"_s);
        QVERIFY(dialog.settles());
        QVERIFY(dialog.at<QPlainTextEdit>("exportText").toPlainText().contains(u"<gpx"_s));
        QVERIFY(dialog.choice().path.endsWith(u"survey.gpx"_s));
    }

    void waypointsAreThoseOfTheOrder()
    {
        Exporting dialog(withUavs(1));
        QVERIFY(dialog.settles());
        const QAbstractItemModel& rows = *dialog.at<QTableView>("exportWaypoints").model();
        QVERIFY(rows.rowCount() >= 4);
        dialog.at<QComboBox>("exportWhat").setCurrentIndex(1);
        QVERIFY(dialog.settles());
        QCOMPARE(rows.rowCount(), 1);
        QVERIFY(dialog.choice().options.what == ExportScope::FirstLeg);
    }

    /** In flight plans are of what is left, tracks of what was flown, unless something is chosen.
     */
    void inFlightPlansAreOfTheOrder()
    {
        Exporting dialog(withUavs(1), {}, 20);
        dialog.choose(u"wpl"_s);
        QVERIFY(dialog.settles());
        QVERIFY(dialog.choice().options.what == ExportScope::Order);
        dialog.choose(u"gpx"_s);
        QVERIFY(dialog.settles());
        QVERIFY(!dialog.choice().options.what);
        auto& what = dialog.at<QComboBox>("exportWhat");
        what.setCurrentIndex(what.count() - 1);
        dialog.choose(u"plan"_s);
        QVERIFY(dialog.settles());
        QVERIFY(dialog.choice().options.what == ExportScope::Path);
    }

    void optionsAreTaken()
    {
        Exporting dialog(withUavs(2), {.formatId = "wpl"});
        QVERIFY(dialog.choice().options == ExportOptions{});
        dialog.at<QComboBox>("exportUav").setCurrentIndex(2);
        dialog.at<NumberField>("exportAltitude").setValue(123);
        dialog.at<NumberField>("exportAirspeed").setValue(25.5);
        dialog.at<NumberField>("exportAcceptance").setValue(80);
        dialog.at<QSpinBox>("exportLoiter").setValue(3);
        dialog.at<QComboBox>("exportReturn").setCurrentIndex(1);
        const ExportOptions wanted{.uav = "uav-2",
                                   .altitude_m = 123,
                                   .airspeed_mps = 25.5,
                                   .acceptance_m = 80,
                                   .loiterTurns = 3,
                                   .returnHome = true};
        QVERIFY(dialog.choice().options == wanted);
        QVERIFY(dialog.settles());
        const std::vector<ExportFile> files = dialog.written();
        QCOMPARE(files.size(), 1U);
        QVERIFY(files.front().content.find("\t123") != std::string::npos);
        QVERIFY(dialog.notes().contains(u"whole number"_s));
    }

    /** Options that the format does not support are disabled and not in the request. */
    void optionsFollowTheFormat()
    {
        Exporting dialog(withUavs(2), {.formatId = "plan", .options = {.loiterTurns = 2}}, 20);
        QCOMPARE(dialog.choice().options.loiterTurns, 2);
        dialog.choose(u"brief"_s);
        QCOMPARE(dialog.choice().options.loiterTurns, 2);
        dialog.choose(u"gpx"_s);
        QVERIFY(!dialog.at<QSpinBox>("exportLoiter").isEnabled());
        QVERIFY(dialog.at<NumberField>("exportAltitude").isEnabled());
        QCOMPARE(dialog.choice().options.loiterTurns, 0);
        dialog.choose(u"zeta-csv"_s);
        QVERIFY(!dialog.at<QComboBox>("exportWhat").isEnabled());
        QVERIFY(!dialog.at<QComboBox>("exportUav").isEnabled());
        QVERIFY(dialog.settles());
        QVERIFY(dialog.choice().path.endsWith(u".csv"_s));
    }

    void refusalIsReportedAndStopsTheExport()
    {
        Scenario scenario = withUavs(1);
        scenario.wind_mps = Point(8, 0);
        Exporting dialog(scenario);
        QVERIFY(dialog.settles());
        dialog.at<NumberField>("exportAirspeed").setValue(5);
        QVERIFY(dialog.isRefused());
        QVERIFY(dialog.notes().contains(u"wind"_s));
        QVERIFY(!dialog.canExport());
        dialog.at<NumberField>("exportAirspeed").setValue(0);
        QVERIFY(dialog.settles());
    }

    /** Whoever is quicker than the preview is not left without a file. */
    void exportWaitsForThePreview()
    {
        Exporting dialog(withUavs(1));
        QVERIFY(dialog.settles());
        QSignalSpy accepted(&dialog.dialog(), &QDialog::accepted);
        const QString path = dialog.folder.filePath(u"typed.plan"_s);
        dialog.at<QLineEdit>("exportPath").setText(path);
        dialog.at<QPushButton>("exportButton").click();
        QTRY_COMPARE(accepted.size(), 1);
        QCOMPARE(dialog.choice().path, path);
    }

    /** Two formats of one ending do not have one name, unless the user gives it. */
    void formatsHaveNamesOfTheirOwn()
    {
        Exporting dialog(withUavs(1));
        const auto pathOf = [&](const QString& format) {
            dialog.choose(format);
            return QFileInfo(dialog.choice().path).fileName();
        };
        QCOMPARE(pathOf(u"plan"_s), u"survey.plan"_s);
        QCOMPARE(pathOf(u"brief"_s), u"survey-brief.pdf"_s);
        QCOMPARE(pathOf(u"map-pdf"_s), u"survey-map.pdf"_s);
        QCOMPARE(pathOf(u"csv"_s), u"survey.csv"_s);
        dialog.at<QLineEdit>("exportPath").setText(u"/tmp/mine.csv"_s);
        QCOMPARE(pathOf(u"brief"_s), u"mine.pdf"_s);
    }

    void folderMustBeThere()
    {
        Exporting dialog(withUavs(1));
        QVERIFY(dialog.settles());
        dialog.at<QLineEdit>("exportPath").setText(dialog.folder.filePath(u"no/where.plan"_s));
        QVERIFY(dialog.at<QLabel>("exportFileNote").text().contains(u"no folder"_s));
        QVERIFY(!dialog.canExport());
        dialog.at<QLineEdit>("exportPath").setText(dialog.folder.filePath(u"here.plan"_s));
        QVERIFY(dialog.settles());
    }

    void saysWhatIsThereAlready()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath(u"old.plan"_s);
        writeFileAtomically(path.toStdString(), "old");
        Exporting dialog(withUavs(1), {.formatId = "plan", .path = path});
        QVERIFY(dialog.settles());
        QVERIFY(dialog.at<QLabel>("exportFileNote").text().contains(u"The file exists"_s));
    }
};

QTEST_MAIN(TestExportDialog)
#include "tst_export_dialog.moc"
