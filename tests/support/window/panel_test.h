#pragma once

#include "widgets/theme/unit_settings.h"

#include <QRegularExpression>
#include <QTranslator>
#include <QWidget>
#include <QtTest>

namespace berg::test {

/** Makes warnings of Qt fail the test, except those about features missing offscreen. */
inline void failOnWarnings()
{
    QTest::failOnWarning(QRegularExpression(QStringLiteral("^(?!This plugin does not support )")));
}

/**
 * Returns the child of that object name and type; if it is missing, the program ends with its name.
 */
template <class Widget>
Widget& child(const QWidget& parent, const QString& name)
{
    auto* found = parent.findChild<Widget*>(name);
    if (found == nullptr)
        qFatal("no child %s", qPrintable(name));
    return *found;
}

/** Lengthens every text, as translations may. */
class LongerTexts final : public QTranslator
{
public:
    explicit LongerTexts(int percent = 30) : m_percent(percent)
    {
        QCoreApplication::installTranslator(this);
    }
    ~LongerTexts() override { QCoreApplication::removeTranslator(this); }
    LongerTexts(const LongerTexts&) = delete;
    LongerTexts& operator=(const LongerTexts&) = delete;

    [[nodiscard]] bool isEmpty() const override { return false; }
    [[nodiscard]] QString translate(const char*, const char* source, const char*,
                                    int count) const override
    {
        QString text = QString::fromUtf8(source);
        text.replace(QStringLiteral("%n"), QString::number(count));
        return text + QString(1 + text.size() * m_percent / 100, u'~');
    }

private:
    int m_percent;
};

/** Sets the units until the end of the scope. */
struct UnitsInUse
{
    explicit UnitsInUse(const Units& units) { setShownUnits(units); }
    ~UnitsInUse() { setShownUnits({}); }
    UnitsInUse(const UnitsInUse&) = delete;
    UnitsInUse& operator=(const UnitsInUse&) = delete;
};

inline constexpr Units kComponents{.vectors = VectorForm::Components};

/** Replaces the text of an input by typing and presses Return. */
inline void enter(QWidget& input, const QString& text)
{
    input.setFocus();
    QTest::keyClick(&input, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(&input, text);
    QTest::keyClick(&input, Qt::Key_Return);
}

inline constexpr int kDock_px = 300; // narrowest dock that the panels are made for

} // namespace berg::test
