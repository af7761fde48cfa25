#include "core/io/files/scenario_json.h"
#include "core/io/text/atomic_file.h"
#include "tests/support/window/map_fixture.h"
#include "tests/support/window/panel_test.h"
#include "widgets/panels/fields/number_field.h"
#include "widgets/panels/inspector/inspector_panel.h"

#include <QClipboard>
#include <QTemporaryDir>

#include <clocale>
#include <locale>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

/** Numbers of the C++ library as in German or Norwegian. */
struct CommaNumbers final : std::numpunct<char>
{
    [[nodiscard]] char do_decimal_point() const override { return ','; }
    [[nodiscard]] char do_thousands_sep() const override { return '.'; }
    [[nodiscard]] std::string do_grouping() const override { return "\3"; }
};

/** Sets everything that determines how a number is written, until the end of the scope. */
class InLocale
{
public:
    explicit InLocale(const QLocale& locale)
        : m_qt(QLocale()), m_cpp(std::locale()), m_c(std::setlocale(LC_ALL, nullptr))
    {
        QLocale::setDefault(locale);
        if (locale == QLocale::c())
            return;
        // If the system does not have it, it stays; the library's numbers change in any case.
        (void)std::setlocale(LC_ALL, qPrintable(locale.name() + u".UTF-8"_s));
        std::locale::global(std::locale(std::locale(), new CommaNumbers));
    }
    ~InLocale()
    {
        std::locale::global(m_cpp);
        (void)std::setlocale(LC_ALL, m_c.c_str());
        QLocale::setDefault(m_qt);
    }
    InLocale(const InLocale&) = delete;
    InLocale& operator=(const InLocale&) = delete;

private:
    QLocale m_qt;
    std::locale m_cpp;
    std::string m_c;
};

struct Written
{
    std::string file;
    QString clipboard;
    Scenario scenario;
};

/** Edits by mouse and by typing numbers in the user's locale, then saves. */
Written editedIn(const QLocale& locale)
{
    const InLocale inLocale(locale);
    const test::UnitsInUse units(test::kComponents);
    const QTemporaryDir folder;
    test::MapFixture map;
    map.view.setLocale(locale);
    InspectorPanel panel(map.document, map.selection);
    panel.setLocale(locale);
    panel.show();
    const auto enter = [&](const QString& key, double value) {
        auto& field = test::child<NumberField>(panel, key);
        QString text = locale.toString(value, 'f', 3);
        text.replace(QChar(0x2212), u'-'); // the minus sign of the keyboard
        test::enter(field, text);
    };
    map.view.tools().setKind(MapToolKind::Area);
    for (const QPoint& at : {QPoint(400, 200), QPoint(650, 210), QPoint(630, 420)})
        map.click(at);
    QTest::keyClick(&map.view, Qt::Key_Return);
    map.view.tools().setKind(MapToolKind::Iceberg);
    map.drag({500, 300}, {560, 255});
    enter(u"icebergVelocityEast"_s, -1.234);
    enter(u"icebergs.q_m2ps"_s, 0.031);
    map.view.edits().copySelected();
    map.view.edits().pasteAt(Point(1234.5, 2345.6));
    map.selection.clear();
    enter(u"duration_s"_s, 12345.5);
    enter(u"planner.reach_radius_m"_s, 71.125);
    const QString path = folder.filePath(u"a.berg"_s);
    map.document.save(path);
    return {.file = readFile(path.toStdString()),
            .clipboard = QApplication::clipboard()->text(),
            .scenario = map.scenario()};
}

} // namespace

/** Files have the same bytes in every locale of the user. */
class TestLocaleFiles : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void filesDoNotDependOnTheLocale_data()
    {
        QTest::addColumn<QLocale>("locale");
        QTest::newRow("de_DE") << QLocale(QLocale::German, QLocale::Germany);
        QTest::newRow("nb_NO") << QLocale(QLocale::NorwegianBokmal, QLocale::Norway);
    }

    void filesDoNotDependOnTheLocale()
    {
        QFETCH(QLocale, locale);
        const Written c = editedIn(QLocale::c());
        QVERIFY(c.file.find("-1.234") != std::string::npos);
        QVERIFY(c.file.find("12345.5") != std::string::npos);
        const Written other = editedIn(locale);
        QVERIFY(other.scenario == c.scenario); // typed with commas
        QCOMPARE(other.file, c.file);
        QCOMPARE(other.clipboard, c.clipboard);
        const InLocale inLocale(locale);
        QVERIFY(scenarioFromJson(c.file, "file") == c.scenario);
    }
};

QTEST_MAIN(TestLocaleFiles)
#include "tst_locale_files.moc"
