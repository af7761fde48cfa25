#include "app/dialogs/import_identity_view.h"

#include "widgets/theme/quantity_text.h"

#include <QButtonGroup>
#include <QGridLayout>
#include <QLabel>
#include <QRadioButton>
#include <QVBoxLayout>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kGap_px = 4;
constexpr int kAcross_px = 24;

QString answerText(const IdentityChoice& choice)
{
    if (!choice.rows)
        return ImportIdentityView::tr("Rows with the same “%1”")
            .arg(QString::fromStdString(choice.column));
    return *choice.rows == RowIdentity::OneIceberg
               ? ImportIdentityView::tr("All rows are one iceberg")
               : ImportIdentityView::tr("Each row is a separate iceberg");
}

QString fastestText(const IdentityChoice& choice, const QLocale& locale)
{
    return choice.outcome.fastest_mps > 0
               ? ImportIdentityView::tr("up to %1 m/s between sightings")
                     .arg(fixedText(choice.outcome.fastest_mps, 2, locale))
               : QString();
}

} // namespace

ImportIdentityView::ImportIdentityView(QWidget* parent) : QWidget(parent)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kGap_px);
    auto* question =
        new QLabel(tr("The file does not say which rows belong to the same iceberg. Choose:"));
    question->setObjectName(u"importQuestion"_s);
    question->setWordWrap(true);
    QFont strong = question->font();
    strong.setBold(true);
    question->setFont(strong);
    column->addWidget(question);
    setVisible(false);
}

void ImportIdentityView::showChoices(const std::vector<IdentityChoice>& choices)
{
    setVisible(!choices.empty());
    if (choices == m_choices)
        return;
    m_choices = choices;
    if (std::find(m_choices.begin(), m_choices.end(), m_chosen) == m_choices.end())
        m_chosen.reset();
    delete m_rows;
    m_rows = new QWidget;
    m_buttons = new QButtonGroup(m_rows);
    m_grid = new QGridLayout(m_rows);
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setVerticalSpacing(kGap_px);
    m_grid->setHorizontalSpacing(kAcross_px);
    m_grid->setColumnStretch(3, 1);
    for (std::size_t i = 0; i < m_choices.size(); ++i)
        addRow(i);
    layout()->addWidget(m_rows);
    m_rows->show(); // a layout on screen would show it later
}

void ImportIdentityView::addRow(std::size_t index)
{
    const IdentityChoice& choice = m_choices[index];
    const int row = static_cast<int>(index);
    auto* button = new QRadioButton(answerText(choice));
    button->setObjectName(u"importIdentity%1"_s.arg(row));
    button->setChecked(m_chosen == choice);
    const QString icebergs = tr("%n icebergs", nullptr, static_cast<int>(choice.outcome.icebergs));
    const QString speed = fastestText(choice, locale());
    button->setAccessibleDescription(speed.isEmpty() ? icebergs : icebergs + u", "_s + speed);
    m_buttons->addButton(button);
    connect(button, &QRadioButton::clicked, this, [this, choice] {
        m_chosen = choice;
        emit edited();
    });
    m_grid->addWidget(button, row, 0);
    m_grid->addWidget(new QLabel(icebergs), row, 1);
    m_grid->addWidget(new QLabel(speed), row, 2);
}

} // namespace berg
