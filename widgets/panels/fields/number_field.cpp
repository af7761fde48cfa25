#include "widgets/panels/fields/number_field.h"

#include "widgets/panels/fields/entry_field.h"
#include "widgets/panels/fields/wheel_guard.h"

#include <QLineEdit>
#include <QStyle>
#include <QStyleOptionSpinBox>
#include <QToolTip>

#include <algorithm>
#include <cmath>
#include <utility>

using namespace Qt::StringLiterals;

namespace berg {

NumberField::NumberField(QWidget* parent) : QDoubleSpinBox(parent)
{
    setKeyboardTracking(false);
    setAccelerated(true);
    guardWheel(*this);
    connect(this, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        if (!isShown(value))
            commit(value);
    });
    connect(this, &QAbstractSpinBox::editingFinished, this, &NumberField::finish);
    connect(lineEdit(), &QLineEdit::textEdited, this, &NumberField::noteTyping);
}

void NumberField::setNumberFormat(Decimals decimals, const QString& unit)
{
    m_leastDecimals = decimals.least;
    m_unit = unit;
    setDecimals(decimals.most);
    setSuffix(m_mixed ? QString() : m_unit);
}

void NumberField::setLowestText(const QString& text)
{
    m_lowestText = text;
    setSpecialValueText(m_mixed ? QString() : text);
    updateGeometry();
}

void NumberField::limit(double low, double high)
{
    if (low != minimum() || high != maximum())
        setRange(low, high);
}

void NumberField::showValue(double value)
{
    showNumber(value, false);
}

void NumberField::showMixed(double base)
{
    showNumber(base, true);
}

void NumberField::showNumber(double value, bool mixed)
{
    // Setting the text anew would take away what the user is typing.
    if (mixed == m_mixed && value == m_shown && isShown(this->value()))
        return;
    m_shown = value;
    m_typed.reset();
    setMixed(mixed);
    setValue(value);
}

void NumberField::setMixed(bool mixed)
{
    if (mixed == m_mixed)
        return;
    m_mixed = mixed;
    lineEdit()->setPlaceholderText(m_mixed ? tr("mixed") : QString());
    // Nothing may stand in the field, or the placeholder does not show.
    setSuffix(m_mixed ? QString() : m_unit);
    setSpecialValueText(m_mixed ? QString() : m_lowestText);
}

/** Whether this is `m_shown` as far as range and decimals let the field hold it. */
bool NumberField::isShown(double value) const
{
    const double held = std::clamp(m_shown, minimum(), maximum());
    return std::abs(value - held) <= 0.5000001 * std::pow(10.0, -decimals());
}

/** A mixed field holds a number that the user cannot see: typing that one is an edit as well. */
void NumberField::noteTyping(const QString& text)
{
    QString copy = text;
    int position = 0;
    m_typed.reset();
    if (m_mixed && validate(copy, position) == QValidator::Acceptable)
        m_typed = valueFromText(copy);
}

void NumberField::commit(double value)
{
    m_shown = value;
    m_typed.reset();
    m_editing = true;
    setMixed(false);
    emit edited(value);
}

void NumberField::finish()
{
    if (m_typed)
        commit(*m_typed);
    settleTyping(*lineEdit());
    if (!std::exchange(m_editing, false))
        return;
    emit editFinished();
}

/** A number beyond the limits can be typed to its end; else its first digits would be taken. */
QValidator::State NumberField::validate(QString& text, int& position) const
{
    const QValidator::State state = QDoubleSpinBox::validate(text, position);
    if (state != QValidator::Invalid)
        return state;
    const std::optional<double> number = numberIn(text);
    return number && (*number < minimum() || *number > maximum()) ? QValidator::Intermediate
                                                                  : QValidator::Invalid;
}

/** Makes it the nearest one that can be set, and says so. */
void NumberField::fixup(QString& text) const
{
    const std::optional<double> number = numberIn(text);
    if (!number)
        return;
    text = prefix() + textFromValue(std::clamp(*number, minimum(), maximum())) + suffix();
    QToolTip::showText(mapToGlobal(rect().bottomLeft()),
                       tr("From %1 to %2").arg(textFromValue(minimum()), textFromValue(maximum())));
}

std::optional<double> NumberField::numberIn(QString text) const
{
    constexpr int kLongest = 20;
    if (text.endsWith(suffix()))
        text.chop(suffix().size());
    bool isNumber = false;
    const double number = locale().toDouble(text.trimmed(), &isNumber);
    return isNumber && std::isfinite(number) && text.size() <= kLongest ? std::optional(number)
                                                                        : std::nullopt;
}

void NumberField::finishTyping()
{
    if (!lineEdit()->isModified())
        return;
    interpretText();
    finish();
}

QString NumberField::textFromValue(double value) const
{
    if (m_mixed)
        return {};
    QLocale plain = locale();
    plain.setNumberOptions(QLocale::OmitGroupSeparator);
    QString text = plain.toString(value, 'f', decimals());
    const qsizetype point = text.indexOf(plain.decimalPoint());
    if (point < 0)
        return text;
    qsizetype keep = text.size();
    while (keep - point - 1 > m_leastDecimals && text[keep - 1] == plain.zeroDigit())
        --keep;
    if (keep == point + 1)
        --keep; // no decimal left
    return text.left(keep);
}

QSize NumberField::sizeHint() const
{
    // The range says nothing about the numbers in use: it may reach to 10^12.
    const QFontMetrics metrics = fontMetrics();
    const int text_px = std::max(metrics.horizontalAdvance(u"-100000.0"_s + m_unit),
                                 metrics.horizontalAdvance(m_lowestText));
    QStyleOptionSpinBox option;
    initStyleOption(&option);
    const QSize content(text_px + 2 * metrics.averageCharWidth(),
                        lineEdit()->minimumSizeHint().height());
    const QSize whole = style()->sizeFromContents(QStyle::CT_SpinBox, &option, content, this);
    return {whole.width(), QDoubleSpinBox::sizeHint().height()};
}

QSize NumberField::minimumSizeHint() const
{
    return sizeHint();
}

} // namespace berg
