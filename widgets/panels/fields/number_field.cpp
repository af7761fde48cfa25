#include "widgets/panels/fields/number_field.h"

#include "widgets/panels/fields/entry_field.h"
#include "widgets/panels/fields/wheel_guard.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/theme/typed_quantity.h"

#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QStyle>
#include <QStyleOptionSpinBox>
#include <QVBoxLayout>

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
    setSuffix(m_mixed || isDuration() ? QString() : m_unit);
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
    // Setting the text again would discard what the user is typing.
    if (mixed == m_mixed && value == m_shown && isShown(this->value()))
        return;
    m_shown = value;
    m_typed.reset();
    emit remarked({});
    setMixed(mixed);
    setValue(value);
}

void NumberField::setMixed(bool mixed)
{
    if (mixed == m_mixed)
        return;
    m_mixed = mixed;
    lineEdit()->setPlaceholderText(m_mixed ? tr("mixed") : QString());
    // The placeholder shows only in an empty field.
    setSuffix(m_mixed || isDuration() ? QString() : m_unit);
    setSpecialValueText(m_mixed ? QString() : m_lowestText);
}

/** Returns whether the field holds `m_shown`, within its range and decimals. */
bool NumberField::isShown(double value) const
{
    const double held = std::clamp(m_shown, minimum(), maximum());
    return std::abs(value - held) <= 0.5000001 * std::pow(10.0, -decimals());
}

/**
 * A mixed field holds a number that the user cannot see, so typing that number is an edit as well.
 */
void NumberField::noteTyping(const QString& text)
{
    QString copy = text;
    int position = 0;
    m_typed.reset();
    if (m_mixed && validate(copy, position) == QValidator::Acceptable)
        m_typed = valueFromText(copy);
    m_typedNumber = numberIn(text); // read before an edit changes the unit shown
    m_typing = text;
    if (!suffix().isEmpty() && m_typing.endsWith(suffix()))
        m_typing.chop(suffix().size());
    m_typing = m_typing.trimmed();
    emit remarked({});
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
    remark();
    if (!std::exchange(m_editing, false))
        return;
    emit editFinished();
}

/** Reports a typed text that was not set as typed. */
void NumberField::remark()
{
    const QString typing = std::exchange(m_typing, QString());
    if (typing.isEmpty() || typing == m_lowestText)
        return;
    const double half = 0.5 * std::pow(10.0, -decimals());
    if (!m_typedNumber)
        emit remarked(
            tr("\"%1\" cannot be read. Type it like %2.").arg(typing, shownText(m_shown)));
    else if (*m_typedNumber > maximum() + half)
        emit remarked(
            tr("\"%1\" is above the highest value. %2 was set.").arg(typing, shownText(maximum())));
    else if (*m_typedNumber < minimum() - half)
        emit remarked(
            tr("\"%1\" is below the lowest value. %2 was set.").arg(typing, shownText(minimum())));
}

/** Accepts text that may still become a number; rejects other keys at once. */
QValidator::State NumberField::validate(QString& text, int& position) const
{
    constexpr int kLongest = 40;
    if (m_mixed && text.isEmpty())
        return QValidator::Intermediate;
    if (!m_lowestText.isEmpty() && text == m_lowestText)
        return QValidator::Acceptable;
    if (hasOtherUnits(m_unit)) {
        QString body = text;
        if (!suffix().isEmpty() && body.endsWith(suffix()))
            body.chop(suffix().size());
        const auto isWritten = [](QChar c) { return c.isLetter() || c == u'%' || c == u'°'; };
        if (std::any_of(body.cbegin(), body.cend(), isWritten)) {
            text = body; // a typed unit replaces the one shown
            position = std::min(position, static_cast<int>(text.size()));
        }
        if (text.size() > kLongest)
            return QValidator::Invalid;
    } else if (const QValidator::State state = QDoubleSpinBox::validate(text, position);
               state != QValidator::Invalid) {
        return state;
    }
    const std::optional<double> number = numberIn(text);
    const bool isInside = number && *number >= minimum() && *number <= maximum();
    if (hasOtherUnits(m_unit))
        return isInside ? QValidator::Acceptable : QValidator::Intermediate;
    return number && !isInside ? QValidator::Intermediate : QValidator::Invalid;
}

double NumberField::valueFromText(const QString& text) const
{
    if (!m_lowestText.isEmpty() && text == m_lowestText)
        return minimum();
    return numberIn(text).value_or(value());
}

/** Replaces a number out of range by the nearest valid one. */
void NumberField::fixup(QString& text) const
{
    if (const std::optional<double> number = numberIn(text))
        text = shownText(std::clamp(*number, minimum(), maximum()));
}

std::optional<double> NumberField::numberIn(QString text) const
{
    constexpr double kMinute_s = 60;
    if (isDuration()) {
        const bool inMinutes =
            !m_mixed && m_shown >= kMinute_s && std::fmod(m_shown, kMinute_s) == 0;
        return durationValue(text, inMinutes ? kMinute_s : 1, locale());
    }
    if (!suffix().isEmpty() && text.endsWith(suffix()))
        text.chop(suffix().size());
    return typedNumber(text, m_unit, locale());
}

bool NumberField::isDuration() const
{
    return m_unit == u" s"_s;
}

QString NumberField::shownText(double value) const
{
    return !m_lowestText.isEmpty() && value == minimum() ? m_lowestText
                                                         : textFromValue(value) + suffix();
}

void NumberField::finishTyping()
{
    // Restoring the suffix clears the line's modified flag.
    if (!lineEdit()->isModified() && m_typing.isEmpty())
        return;
    interpretText();
    finish();
}

bool NumberField::focusNextPrevChild(bool next)
{
    finishTyping();
    return QDoubleSpinBox::focusNextPrevChild(next);
}

QString NumberField::textFromValue(double value) const
{
    if (m_mixed)
        return {};
    if (isDuration())
        return fieldDurationText(value, decimals(), locale());
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
        --keep; // removes the decimal point
    return text.left(keep);
}

QSize NumberField::sizeHint() const
{
    // The range does not limit the numbers in use: it may reach to 10^12.
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

QWidget* withRemark(NumberField* field)
{
    auto* whole = new QWidget;
    auto* remark = new QLabel;
    remark->setObjectName(field->objectName() + u"Fault"_s);
    remark->setWordWrap(true);
    remark->hide();
    auto* column = new QVBoxLayout(whole);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    column->addWidget(field);
    column->addWidget(remark);
    whole->setFocusProxy(field);
    QObject::connect(field, &NumberField::remarked, remark, [remark](const QString& sentence) {
        remark->setText(sentence);
        remark->setAccessibleName(sentence);
        remark->setVisible(!sentence.isEmpty());
    });
    return whole;
}

void addNumberRow(QFormLayout& form, const QString& text, NumberField* field)
{
    auto* label = new QLabel(text);
    form.addRow(label, withRemark(field));
    label->setBuddy(field); // the form set it to the surrounding widget
    // Screen readers do not find the label, which is not a sibling.
    field->setAccessibleName(QString(text).remove(u'&'));
}

} // namespace berg
