#include "widgets/theme/contrast_style.h"
#include "widgets/theme/palette.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QSlider>
#include <QStyleOptionDockWidget>
#include <QtTest>

using namespace berg;

namespace {

/** The greatest contrast of a pixel of `place` with the ground of the widget. */
double contrastIn(QWidget& widget, const QRect& place)
{
    const QImage image = widget.grab().toImage();
    const QColor ground = widget.palette().color(QPalette::Window);
    double best = 1;
    for (int y = place.top(); y <= place.bottom(); ++y)
        for (int x = place.left(); x <= place.right(); ++x)
            best = std::max(best, contrastRatio(image.pixelColor(x, y), ground));
    return best;
}

/** Coloured and in the style of the window. */
template <class Widget>
void dress(Widget& widget, const Theme& theme, ContrastStyle& style)
{
    widget.setPalette(paletteOf(theme));
    widget.setAutoFillBackground(true);
    widget.setStyle(&style);
    widget.resize(widget.sizeHint().expandedTo({120, 20}));
}

} // namespace

/** Measured in pictures of the controls, in both themes. */
class TestContrastStyle : public QObject
{
    Q_OBJECT

private slots:
    void uncheckedIsSeen_data()
    {
        QTest::addColumn<bool>("isDark");
        QTest::newRow("light") << false;
        QTest::newRow("dark") << true;
    }

    void uncheckedIsSeen()
    {
        QFETCH(bool, isDark);
        const Theme theme = isDark ? Theme::dark() : Theme::light();
        ContrastStyle style(QStringLiteral("fusion"));
        QCheckBox box;
        dress(box, theme, style);
        QStyleOptionButton option;
        option.initFrom(&box);
        const QRect square = style.subElementRect(QStyle::SE_CheckBoxIndicator, &option, &box);
        const double ofBox = contrastIn(box, {square.left(), square.top(), square.width(), 1});
        QVERIFY2(ofBox >= 3, QByteArray::number(ofBox));
        QRadioButton circle;
        dress(circle, theme, style);
        option.initFrom(&circle);
        const QRect round = style.subElementRect(QStyle::SE_RadioButtonIndicator, &option, &circle);
        const double ofCircle = contrastIn(circle, {round.left(), round.center().y(), 2, 1});
        QVERIFY2(ofCircle >= 2.9, QByteArray::number(ofCircle)); // antialiased
    }

    void fieldsAreSeen_data()
    {
        QTest::addColumn<int>("themeIndex");
        QTest::newRow("dark") << 0;
        QTest::newRow("contrast, dark") << 1;
        QTest::newRow("night") << 2;
    }

    /** Their edges; a field is as dark as what it stands on. */
    void fieldsAreSeen()
    {
        QFETCH(int, themeIndex);
        const Theme themes[] = {Theme::dark(), Theme::highContrast(true), Theme::night()};
        ContrastStyle style(QStringLiteral("fusion"));
        QLineEdit line;
        QDoubleSpinBox number;
        QPlainTextEdit page;
        for (QWidget* field : std::initializer_list<QWidget*>{&line, &number, &page}) {
            dress(*field, themes[themeIndex], style);
            const double edge = contrastIn(*field, {field->width() / 3, 0, 10, 1});
            QVERIFY2(edge >= 2.9, field->metaObject()->className()); // antialiased
        }
    }

    void switchedOnIsSeen_data() { uncheckedIsSeen_data(); }

    /** A button like "Listen" shows by its edge whether it is on. */
    void switchedOnIsSeen()
    {
        QFETCH(bool, isDark);
        ContrastStyle style(QStringLiteral("fusion"));
        QPushButton button;
        button.setCheckable(true);
        dress(button, isDark ? Theme::dark() : Theme::light(), style);
        const auto middleOfEdge = [&] {
            return button.grab().toImage().pixelColor(button.width() / 2, 0);
        };
        const QColor off = middleOfEdge();
        button.setChecked(true);
        const QColor on = middleOfEdge();
        const QColor highlight = button.palette().color(QPalette::Highlight);
        QVERIFY(contrastRatio(on, off) > 1.5);
        QVERIFY(contrastRatio(on, highlight) < 1.5); // antialiased
    }

    /** Nothing blue or white is in it. */
    void iconsOfBoxesAreRedAtNight()
    {
        ContrastStyle style(QStringLiteral("fusion"));
        QWidget box;
        const auto bluest = [&](const Theme& theme) {
            box.setPalette(paletteOf(theme));
            const QImage icon = style.standardIcon(QStyle::SP_MessageBoxQuestion, nullptr, &box)
                                    .pixmap(48, 48)
                                    .toImage();
            int most = 0;
            for (int y = 0; y < icon.height(); ++y)
                for (int x = 0; x < icon.width(); ++x) {
                    const QColor colour = icon.pixelColor(x, y);
                    if (colour.alpha() > 0)
                        most = std::max(most, colour.blue() - colour.red());
                }
            return most;
        };
        QVERIFY(bluest(Theme::dark()) > 0);
        QVERIFY(bluest(Theme::night()) <= 0);
    }

    /** The window frame shows the title of a floating dock. */
    void titleOfADockIsThereOnce()
    {
        ContrastStyle style(QStringLiteral("fusion"));
        const auto painted = [&](Qt::WindowType type, const QString& title) {
            const QWidget dock(nullptr, type);
            QStyleOptionDockWidget option;
            option.rect = {0, 0, 200, 20};
            option.title = title;
            QImage image(200, 20, QImage::Format_RGB32);
            image.fill(Qt::white);
            QPainter painter(&image);
            style.drawControl(QStyle::CE_DockWidgetTitle, &option, &painter, &dock);
            return image;
        };
        const QString title = QStringLiteral("Study");
        QCOMPARE(painted(Qt::Window, title), painted(Qt::Window, {}));
        QVERIFY(painted(Qt::Tool, title) != painted(Qt::Tool, {}));
    }

    void grooveIsSeen_data() { uncheckedIsSeen_data(); }

    /** On both sides of the handle. */
    void grooveIsSeen()
    {
        QFETCH(bool, isDark);
        const Theme theme = isDark ? Theme::dark() : Theme::light();
        ContrastStyle style(QStringLiteral("fusion"));
        QSlider slider(Qt::Horizontal);
        dress(slider, theme, style);
        slider.setValue(50);
        for (const int x : {slider.width() / 4, slider.width() * 3 / 4}) {
            const double contrast = contrastIn(slider, {x, 0, 1, slider.height()});
            QVERIFY2(contrast >= 3, QByteArray::number(contrast));
        }
    }
};

QTEST_MAIN(TestContrastStyle)
#include "tst_contrast_style.moc"
