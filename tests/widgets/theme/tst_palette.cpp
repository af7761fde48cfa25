#include "tests/support/window/themes.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/palette.h"

#include <QtTest>

using namespace berg;
using test::themes;

namespace {

constexpr double kTextContrast = 4.5; // WCAG 2.1, 1.4.3
constexpr double kLineContrast = 3.0; // WCAG 2.1, 1.4.11

const Theme& themeOf(int themeIndex)
{
    return themes()[static_cast<std::size_t>(themeIndex)].theme;
}

struct Pair
{
    const char* name;
    QPalette::ColorRole on;
    QPalette::ColorRole below;
    double least;
};

constexpr Pair kPairs[] = {
    {"text of labels", QPalette::WindowText, QPalette::Window, kTextContrast},
    {"text of lists and fields", QPalette::Text, QPalette::Base, kTextContrast},
    {"text of every second row", QPalette::Text, QPalette::AlternateBase, kTextContrast},
    {"text of locked fields", QPalette::Text, QPalette::Window, kTextContrast},
    {"text of buttons", QPalette::ButtonText, QPalette::Button, kTextContrast},
    {"text of flat buttons", QPalette::ButtonText, QPalette::Window, kTextContrast},
    {"text of tool tips", QPalette::ToolTipText, QPalette::ToolTipBase, kTextContrast},
    {"what a field expects", QPalette::PlaceholderText, QPalette::Base, kTextContrast},
    {"text of the chosen row", QPalette::HighlightedText, QPalette::Highlight, kTextContrast},
    {"links", QPalette::Link, QPalette::Window, kTextContrast},
    {"the chosen row in a list", QPalette::Highlight, QPalette::Base, kLineContrast},
    {"focus on a panel", QPalette::Highlight, QPalette::Window, kLineContrast},
};

} // namespace

class TestPalette : public QObject
{
    Q_OBJECT

private slots:
    void contrastIsEnough_data()
    {
        QTest::addColumn<int>("themeIndex");
        QTest::addColumn<int>("pair");
        for (std::size_t themeIndex = 0; themeIndex < themes().size(); ++themeIndex)
            for (std::size_t i = 0; i < std::size(kPairs); ++i)
                QTest::addRow("%s: %s", themes()[themeIndex].name, kPairs[i].name)
                    << static_cast<int>(themeIndex) << static_cast<int>(i);
    }

    void contrastIsEnough()
    {
        QFETCH(int, themeIndex);
        QFETCH(int, pair);
        const QPalette palette = paletteOf(themeOf(themeIndex));
        const Pair& p = kPairs[pair];
        for (const auto group : {QPalette::Active, QPalette::Inactive}) {
            const double ratio =
                contrastRatio(palette.color(group, p.on), palette.color(group, p.below));
            QVERIFY2(ratio >= p.least, QByteArray::number(ratio).constData());
        }
    }

    void highContrastHasMore_data()
    {
        QTest::addColumn<bool>("isDark");
        QTest::addColumn<int>("pair");
        for (const bool isDark : {false, true})
            for (std::size_t i = 0; i < std::size(kPairs); ++i)
                QTest::addRow("%s: %s", isDark ? "dark" : "light", kPairs[i].name)
                    << isDark << static_cast<int>(i);
    }

    void highContrastHasMore()
    {
        QFETCH(bool, isDark);
        QFETCH(int, pair);
        const QPalette palette = paletteOf(Theme::highContrast(isDark));
        const Pair& p = kPairs[pair];
        const double ratio = contrastRatio(palette.color(p.on), palette.color(p.below));
        QVERIFY2(ratio >= (p.least == kTextContrast ? 7 : 4.5),
                 QByteArray::number(ratio).constData());
    }

    void sigmaAndMutedTextOnPanels_data()
    {
        QTest::addColumn<int>("themeIndex");
        for (std::size_t i = 0; i < themes().size(); ++i)
            QTest::newRow(themes()[i].name) << static_cast<int>(i);
    }

    /** Lines in theme colours on panels have enough contrast on backgrounds of the palette. */
    void sigmaAndMutedTextOnPanels()
    {
        QFETCH(int, themeIndex);
        const Theme& theme = themeOf(themeIndex);
        const QPalette palette = paletteOf(theme);
        for (const auto ground : {QPalette::Window, QPalette::Base}) {
            QVERIFY(contrastRatio(theme.mutedText, palette.color(ground)) >= kTextContrast);
            for (int i = 0; i <= 100; ++i)
                QVERIFY2(contrastRatio(theme.sigma.at(i / 100.0), palette.color(ground)) >=
                             kLineContrast,
                         QByteArray::number(i).constData());
        }
    }

    void disabledIsFainterButThere_data() { sigmaAndMutedTextOnPanels_data(); }

    void disabledIsFainterButThere()
    {
        QFETCH(int, themeIndex);
        const QPalette palette = paletteOf(themeOf(themeIndex));
        const double least = themeOf(themeIndex).isNight ? kLineContrast : 1.5;
        for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
            const QColor ground = palette.color(QPalette::Window);
            const double disabled = contrastRatio(palette.color(QPalette::Disabled, role), ground);
            QVERIFY(disabled < contrastRatio(palette.color(QPalette::Active, role), ground));
            QVERIFY(disabled > least); // WCAG exempts it, but it must be visible
        }
    }

    void uavColoursDiffer_data() { sigmaAndMutedTextOnPanels_data(); }

    void uavColoursDiffer()
    {
        QFETCH(int, themeIndex);
        const Theme& theme = themeOf(themeIndex);
        QCOMPARE(uavColour(theme, 0), theme.uav);
        QCOMPARE(uavColour(theme, kUavColours), theme.uav); // they begin anew
        for (int i = 0; i < kUavColours; ++i) {
            const QColor colour = uavColour(theme, i);
            for (const QColor& ground : {theme.sea, theme.land, theme.panel, theme.chart})
                QVERIFY2(contrastRatio(colour, ground) >= kLineContrast, qPrintable(colour.name()));
            for (int k = 0; k < i; ++k) {
                const QColor other = uavColour(theme, k);
                // Neighbours in lightness differ in hue by far; reds only as `tst_colour_vision`
                // measures it.
                const int hue = std::abs(colour.hslHue() - other.hslHue());
                QVERIFY2(theme.isNight || contrastRatio(colour, other) > 1.5 ||
                             std::min(hue, 360 - hue) > 25,
                         qPrintable(colour.name() + other.name()));
            }
        }
    }

    /** Icons of rows are drawn in the mode of their row. */
    void iconsAreSeenOnTheirGround()
    {
        for (const auto& [name, theme] : themes()) {
            const auto inkOf = [&shown = theme](QIcon::Mode mode) {
                const QImage image =
                    icon(IconName::Warning, shown).pixmap(QSize(32, 32), mode).toImage();
                for (int y = 0; y < image.height(); ++y)
                    for (int x = 0; x < image.width(); ++x)
                        if (image.pixelColor(x, y).alpha() == 255)
                            return image.pixelColor(x, y);
                return QColor();
            };
            const QColor chosen = paletteOf(theme).color(QPalette::Highlight);
            QVERIFY(contrastRatio(inkOf(QIcon::Normal), theme.panel) >= kLineContrast);
            QVERIFY(contrastRatio(inkOf(QIcon::Selected), chosen) >= kLineContrast);
        }
    }

    void themesDiffer()
    {
        const auto luminance = [](int themeIndex) {
            return relativeLuminance(paletteOf(themeOf(themeIndex)).color(QPalette::Window));
        };
        QVERIFY(luminance(0) > 0.8);
        QVERIFY(luminance(1) < 0.05);
        QVERIFY(luminance(2) < 0.005);
    }

    /** Every colour of the palette, whatever a style makes of it. */
    void nightIsRed()
    {
        const QPalette palette = paletteOf(Theme::night());
        for (const auto group : {QPalette::Active, QPalette::Inactive, QPalette::Disabled})
            for (int role = 0; role < QPalette::NColorRoles; ++role) {
                if (role == QPalette::NoRole || role == QPalette::LinkVisited)
                    continue; // no link is shown as visited
                const QColor colour = palette.color(group, static_cast<QPalette::ColorRole>(role));
                QVERIFY2(colour.red() >= colour.green() && colour.red() >= colour.blue(),
                         QByteArray::number(role));
            }
    }
};

QTEST_MAIN(TestPalette)
#include "tst_palette.moc"
