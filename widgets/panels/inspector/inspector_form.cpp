#include "widgets/panels/inspector/inspector_form.h"

#include "core/base/error.h"
#include "widgets/panels/fields/entry_field.h"
#include "widgets/panels/fields/fold_heading.h"
#include "widgets/panels/fields/number_field.h"
#include "widgets/panels/fields/panel_labels.h"
#include "widgets/panels/fields/wheel_guard.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTextDocument>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kNotesLines = 3;
constexpr int kRowGap_px = 4;
constexpr int kColumnGap_px = 8;
constexpr int kLabels_px = 90; ///< longer labels wrap, so that all fields stand beside

/** A text page that reports when it loses the focus. */
class NotesEdit final : public QPlainTextEdit
{
public:
    NotesEdit(std::function<void()> finished, QWidget* parent)
        : QPlainTextEdit(parent), m_finished(std::move(finished))
    {
        setTabChangesFocus(true);
        const QFontMetrics metrics(font());
        setFixedHeight(kNotesLines * metrics.lineSpacing() + 2 * frameWidth() +
                       static_cast<int>(2 * document()->documentMargin()));
    }

protected:
    void focusOutEvent(QFocusEvent* event) override
    {
        QPlainTextEdit::focusOutEvent(event);
        // Context menus and other programs take the focus only for a moment, as in QLineEdit.
        if (event->reason() != Qt::PopupFocusReason &&
            event->reason() != Qt::ActiveWindowFocusReason)
            m_finished();
    }

private:
    std::function<void()> m_finished;
};

QLabel* newLabel(const QString& text, QWidget* input)
{
    auto* label = new QLabel(text);
    label->setBuddy(input);
    label->setWordWrap(true);
    int widest_px = kLabels_px;
    for (const QString& part : text.split(u' '))
        widest_px = std::max(widest_px, label->fontMetrics().horizontalAdvance(part));
    // A label by itself wraps sooner, and the layout asks for the column's width.
    const int width_px = std::min(widest_px, label->fontMetrics().horizontalAdvance(text)) + 1;
    label->setFixedWidth(width_px);
    label->setMinimumHeight(label->heightForWidth(width_px));
    return label;
}

/** Returns whether numbers are equal except for rounding in conversions. */
bool isAlike(double a, double b)
{
    constexpr double kRounding = 1e-9;
    return std::abs(a - b) <= kRounding * std::max(1.0, std::abs(a));
}

template <class Value>
bool isAlike(const Value& a, const Value& b)
{
    return a == b;
}

} // namespace

InspectorForm::InspectorForm(ScenarioDocument& document, const std::vector<InspectorRow>& rows,
                             QWidget* parent)
    : QWidget(parent), m_document(document), m_form(new QFormLayout(this)), m_groups(*m_form)
{
    m_form->setContentsMargins(0, 0, 0, 0);
    m_form->setVerticalSpacing(kRowGap_px);
    m_form->setHorizontalSpacing(kColumnGap_px);
    m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    m_form->setRowWrapPolicy(QFormLayout::DontWrapRows);
    m_form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    for (const InspectorRow& row : rows)
        std::visit([this](const auto& one) { add(one); }, row);
}

void InspectorForm::addOnTop(const QString& label, QWidget* input)
{
    m_top = input;
    m_form->insertRow(0, newLabel(label, input), input);
    for (int row = 1; row < m_form->rowCount(); ++row) {
        QWidget* next = m_form->itemAt(row, QFormLayout::FieldRole)->widget();
        setTabOrder(input, next);
        input = next;
    }
}

void InspectorForm::setTopVisible(bool visible)
{
    m_top->setVisible(visible);
    m_form->labelForField(m_top)->setVisible(visible);
}

void InspectorForm::addInput(const RowWords& words, QWidget* input)
{
    input->setObjectName(words.key);
    input->setAccessibleName(words.label);
    input->setToolTip(words.toolTip);
    auto* number = qobject_cast<NumberField*>(input);
    QWidget* row = number != nullptr ? withRemark(number) : input;
    m_groups.add(newLabel(words.label, input), row);
    showWhere(words, row);
    m_inputs.push_back({.words = words, .input = input});
    if (m_first == nullptr)
        m_first = input;
}

std::vector<RowWords> InspectorForm::inputsOf(const std::string& id) const
{
    std::vector<RowWords> found;
    for (const Input& one : m_inputs)
        if (!one.words.isShown || one.words.isShown(m_document.scenario(), id))
            found.push_back(one.words);
    return found;
}

QWidget* InspectorForm::goTo(const QString& key)
{
    const auto found =
        std::ranges::find(m_inputs, key, [](const Input& one) { return one.words.key; });
    require(found != m_inputs.end(), "an input is gone to by its key");
    m_groups.open(found->input);
    found->input->setFocus(Qt::ShortcutFocusReason);
    return found->input;
}

void InspectorForm::add(const GroupRow& row)
{
    const FoldHeading* heading = m_groups.begin(row.key, row.title, row.isFolded);
    connect(heading, &FoldHeading::toggled, this, [this] {
        finishTyping(); // hidden inputs must not keep unfinished text
        m_groups.show();
    });
    connect(heading, &FoldHeading::clicked, this, &InspectorForm::folded);
}

/** Shows the input only while it matters to one of the edited objects. */
void InspectorForm::showWhere(const RowWords& words, QWidget* input)
{
    if (!words.isShown)
        return;
    m_shows.emplace_back([this, isShown = words.isShown, input] {
        const auto matters = [&](const std::string& id) {
            return isShown(m_document.scenario(), id);
        };
        m_groups.setRelevant(input, std::any_of(m_ids.begin(), m_ids.end(), matters));
    });
}

template <class Read>
auto InspectorForm::common(const Read& read) const
{
    using Value = decltype(read(m_document.scenario(), std::string()));
    std::optional<Value> value;
    for (const std::string& id : m_ids) {
        Value next = read(m_document.scenario(), id);
        if (value && !isAlike(*value, next))
            return std::optional<Value>();
        value = std::move(next);
    }
    return value;
}

std::optional<QString> InspectorForm::commonText(const ReadText& read) const
{
    return common([&](const Scenario& scenario, const std::string& id) {
        return read(scenario, id, locale());
    });
}

void InspectorForm::add(const NumberRow& row)
{
    auto* field = new NumberField;
    field->setNumberFormat(row.decimals, row.unit);
    field->setSingleStep(row.step);
    field->setLowestText(row.lowestText);
    addInput(row.words, field);
    connect(field, &NumberField::edited, this, [this, row](double value) {
        edit(row.words,
             [&](Scenario& scenario, const std::string& id) { row.write(scenario, id, value); });
    });
    connect(field, &NumberField::editFinished, &m_document, &ScenarioDocument::endGesture);
    m_shows.emplace_back([this, row, field] {
        const Limits range = row.range(m_document.scenario());
        field->limit(range.low, range.high);
        if (const std::optional<double> value = common(row.read))
            field->showValue(*value);
        else
            field->showMixed(row.read(m_document.scenario(), m_ids.front()));
    });
}

void InspectorForm::add(const TextRow& row)
{
    if (row.multiLine)
        addPage(row);
    else
        addLine(row);
}

void InspectorForm::addLine(const TextRow& row)
{
    auto* line = new QLineEdit;
    addInput(row.words, line);
    connect(line, &QLineEdit::textEdited, this, [this, row](const QString& text) {
        edit(row.words, [&](Scenario& scenario, const std::string& id) {
            row.write(scenario, id, text.toStdString());
        });
    });
    connect(line, &QLineEdit::editingFinished, this, [this, line] {
        m_document.endGesture();
        settleTyping(*line);
    });
    m_shows.emplace_back([this, row, line] {
        const std::optional<std::string> value = common(row.read);
        const QString text = QString::fromStdString(value.value_or(""));
        line->setPlaceholderText(value ? QString() : tr("mixed"));
        if (text != line->text()) {
            line->setText(text);
            line->setCursorPosition(0);
        }
    });
}

namespace {

/** Returns the text as a page returns it: spaces and line ends are normalised. */
QString asPageHasIt(const QString& text)
{
    QTextDocument page;
    page.setPlainText(text);
    return page.toPlainText();
}

} // namespace

void InspectorForm::addPage(const TextRow& row)
{
    auto* page = new NotesEdit([this] { finishTyping(); }, this);
    addInput(row.words, page);
    connect(page, &QPlainTextEdit::textChanged, this, [this, row, page] {
        const QString text = page->toPlainText();
        const std::optional<std::string> before = common(row.read);
        if (before && asPageHasIt(QString::fromStdString(*before)) == text)
            return; // the text was shown, not typed
        edit(row.words, [&](Scenario& scenario, const std::string& id) {
            row.write(scenario, id, text.toStdString());
        });
    });
    m_shows.emplace_back([this, row, page] {
        const QString text = QString::fromStdString(common(row.read).value_or(""));
        if (asPageHasIt(text) != page->toPlainText())
            page->setPlainText(text);
    });
}

void InspectorForm::add(const EntryRow& row)
{
    const auto faultOf = [this, row](const QString& text) {
        Scenario tried = m_document.scenario();
        QString fault =
            m_ids.size() > 1 && row.faultForSeveral ? row.faultForSeveral(text) : QString();
        for (const std::string& id : m_ids)
            if (fault.isEmpty())
                fault = row.apply(tried, id, text, locale());
        return fault;
    };
    auto* field = new EntryField(
        {.key = row.words.key, .label = row.words.label, .toolTip = row.words.toolTip},
        EntryField::ValidationTime::WhenFinished, faultOf);
    m_groups.add(newLabel(row.words.label, field), field);
    m_inputs.push_back({.words = row.words, .input = field});
    showWhere(row.words, field);
    connect(field, &EntryField::edited, this, [this, row](const QString& text) {
        m_document.endGesture();
        edit(row.words, [&](Scenario& scenario, const std::string& id) {
            const QString fault = row.apply(scenario, id, text, locale());
            require(fault.isEmpty(), "a text that was found good is taken");
        });
        m_document.endGesture();
    });
    m_shows.emplace_back([this, row, field] {
        const std::optional<QString> text = commonText(row.read);
        field->showText(text.value_or(QString()), text ? row.placeholder : tr("mixed"));
    });
}

void InspectorForm::add(const FlagRow& row)
{
    auto* box = new QCheckBox;
    addInput(row.words, box);
    connect(box, &QCheckBox::clicked, this, [this, row](bool on) {
        edit(row.words,
             [&](Scenario& scenario, const std::string& id) { row.write(scenario, id, on); });
        m_document.endGesture();
    });
    m_shows.emplace_back([this, row, box] { box->setChecked(common(row.read).value_or(false)); });
}

void InspectorForm::add(const PickRow& row)
{
    auto* combo = new QComboBox;
    combo->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    combo->setPlaceholderText(tr("mixed"));
    guardWheel(*combo);
    addInput(row.words, combo);
    connect(combo, &QComboBox::activated, this, [this, row](int choice) {
        const std::string value =
            row.options(m_document.scenario())[static_cast<std::size_t>(choice)].value;
        edit(row.words,
             [&](Scenario& scenario, const std::string& id) { row.write(scenario, id, value); });
        m_document.endGesture();
        if (row.chosen)
            row.chosen(m_document, value);
    });
    m_shows.emplace_back([this, row, combo, shown = std::vector<PickRow::Option>()]() mutable {
        const std::vector<PickRow::Option> options = row.options(m_document.scenario());
        if (options != shown) {
            combo->clear();
            for (const PickRow::Option& option : options)
                combo->addItem(option.text);
            shown = options;
        }
        const std::optional<std::string> value = common(row.read);
        const auto chosen =
            std::find_if(options.begin(), options.end(),
                         [&](const PickRow::Option& option) { return option.value == value; });
        combo->setCurrentIndex(
            chosen == options.end() ? -1 : static_cast<int>(chosen - options.begin()));
    });
}

void InspectorForm::add(const ActionRow& row)
{
    auto* button = new QPushButton(row.words.undoText);
    button->setObjectName(row.words.key);
    button->setToolTip(row.words.toolTip);
    m_groups.add(nullptr, button);
    showWhere(row.words, button);
    if (m_first == nullptr)
        m_first = button;
    connect(button, &QPushButton::clicked, this, [this, row] {
        m_document.endGesture();
        m_document.edit(row.words.undoText, row.act);
    });
}

void InspectorForm::add(const PartRow& row)
{
    auto* part = new QWidget;
    auto* line = new QHBoxLayout(part);
    line->setContentsMargins(0, 0, 0, 0);
    auto* text = new QLabel;
    text->setToolTip(row.words.toolTip);
    auto* button = new QPushButton(row.removeText);
    button->setObjectName(row.words.key);
    button->setToolTip(row.words.undoText);
    button->setAccessibleName(row.words.undoText);
    line->addWidget(text, 1);
    line->addWidget(button);
    m_groups.add(newLabel(row.words.label, part), part);
    connect(button, &QPushButton::clicked, this, [this, row] {
        edit(row.words, row.remove);
        m_document.endGesture();
    });
    showText(row.text, *text, part);
}

void InspectorForm::add(const InfoRow& row)
{
    auto* text = new CaptionLabel;
    text->setObjectName(row.key);
    text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_groups.add(new QLabel, text);
    showText(row.text, *text, text);
}

/** Shows the text in a row that is hidden while the text is empty. */
void InspectorForm::showText(const ReadText& read, QLabel& label, QWidget* row)
{
    m_shows.emplace_back([this, read, &label, row] {
        const QString text = commonText(read).value_or(tr("mixed"));
        label.setText(text);
        m_groups.setRelevant(row, !text.isEmpty());
    });
}

void InspectorForm::edit(const RowWords& words,
                         const std::function<void(Scenario&, const std::string& id)>& change)
{
    QString gesture = words.key;
    for (const std::string& id : m_ids)
        gesture += u'|' + QString::fromStdString(id);
    m_document.edit(
        words.undoText,
        [&](Scenario& scenario) {
            for (const std::string& id : m_ids)
                change(scenario, id);
        },
        gesture);
    showAll(); // also shows normalised values, e.g. 0° for 360°
}

void InspectorForm::showObjects(std::vector<std::string> ids)
{
    if (ids != m_ids)
        for (NumberField* field : findChildren<NumberField*>())
            emit field->remarked({}); // the remark concerns another object
    m_ids = std::move(ids);
    showAll();
}

void InspectorForm::showAll()
{
    if (m_ids.empty())
        return;
    for (const auto& showInput : m_shows)
        showInput();
    m_groups.show();
}

void InspectorForm::setLocked(bool locked)
{
    for (NumberField* field : findChildren<NumberField*>()) {
        field->setReadOnly(locked);
        field->setButtonSymbols(locked ? QAbstractSpinBox::NoButtons
                                       : QAbstractSpinBox::UpDownArrows);
        setLockedStyle(*field, locked);
    }
    for (EntryField* field : findChildren<EntryField*>())
        field->setLocked(locked);
    for (QLineEdit* line : findChildren<QLineEdit*>(Qt::FindDirectChildrenOnly)) {
        line->setReadOnly(locked);
        setLockedStyle(*line, locked);
    }
    for (QPlainTextEdit* page : findChildren<QPlainTextEdit*>()) {
        page->setReadOnly(locked);
        setLockedStyle(*page, locked);
    }
    for (QAbstractButton* button : findChildren<QAbstractButton*>())
        button->setEnabled(!locked || qobject_cast<FoldHeading*>(button) != nullptr);
    for (QComboBox* combo : findChildren<QComboBox*>())
        combo->setEnabled(!locked);
}

void InspectorForm::finishTyping()
{
    for (NumberField* field : findChildren<NumberField*>())
        field->finishTyping();
    for (EntryField* field : findChildren<EntryField*>())
        if (field->isVisible())
            field->finishTyping();
    for (QLineEdit* line : findChildren<QLineEdit*>())
        settleTyping(*line);
    for (const QPlainTextEdit* page : findChildren<QPlainTextEdit*>())
        page->document()->clearUndoRedoStacks();
    m_document.endGesture();
}

} // namespace berg
