#include "app/dialogs/recovery_dialog.h"

#include <QDialogButtonBox>
#include <QDir>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr QSize kSize_px(680, 300);

} // namespace

RecoveryDialog::RecoveryDialog(const std::vector<RecoveryOffer>& offers, QWidget* parent)
    : QDialog(parent), m_list(new QTableWidget)
{
    setWindowTitle(tr("Recovered work"));
    auto* column = new QVBoxLayout(this);
    auto* words = new QLabel(tr("Bergwatch ended unexpectedly. Unsaved changes were kept. Restore "
                                "them, and then save them."));
    words->setWordWrap(true);
    column->addWidget(words);
    column->addWidget(m_list, 1);
    fill(offers);
    auto* buttons = new QDialogButtonBox;
    const auto add = [&](const char* name, const QString& text, QDialogButtonBox::ButtonRole role,
                         RecoveryAnswer::Action action) {
        QPushButton* button = buttons->addButton(text, role);
        button->setObjectName(QLatin1String(name));
        connect(button, &QPushButton::clicked, this, [this, action] { end(action); });
        return button;
    };
    using Action = RecoveryAnswer::Action;
    add("restoreButton", tr("&Restore"), QDialogButtonBox::AcceptRole, Action::Restore)
        ->setDefault(true);
    add("discardButton", tr("&Discard"), QDialogButtonBox::DestructiveRole, Action::Discard);
    add("laterButton", tr("&Later"), QDialogButtonBox::RejectRole, Action::Later);
    column->addWidget(buttons);
    connect(m_list, &QTableWidget::cellDoubleClicked, this, [this] { end(Action::Restore); });
    resize(kSize_px);
}

void RecoveryDialog::fill(const std::vector<RecoveryOffer>& offers)
{
    m_list->setObjectName(u"recoveryList"_s);
    m_list->setAccessibleName(windowTitle());
    m_list->setColumnCount(3);
    m_list->setHorizontalHeaderLabels({tr("Name"), tr("Changed"), tr("File")});
    m_list->setRowCount(static_cast<int>(offers.size()));
    for (int row = 0; row < m_list->rowCount(); ++row) {
        const RecoveryOffer& offer = offers[static_cast<std::size_t>(row)];
        const QString file =
            offer.path.isEmpty() ? tr("not saved yet") : QDir::toNativeSeparators(offer.path);
        const QStringList cells{offer.name, offer.edited, file};
        for (int column = 0; column < cells.size(); ++column) {
            auto* item = new QTableWidgetItem(cells[column]);
            item->setToolTip(cells[column]);
            m_list->setItem(row, column, item);
        }
    }
    m_list->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_list->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_list->setSelectionMode(QAbstractItemView::SingleSelection);
    m_list->setTabKeyNavigation(false);
    m_list->setShowGrid(false);
    m_list->verticalHeader()->hide();
    m_list->horizontalHeader()->setHighlightSections(false);
    m_list->horizontalHeader()->setStretchLastSection(true);
    m_list->resizeColumnsToContents();
    m_list->selectRow(0);
}

void RecoveryDialog::end(RecoveryAnswer::Action action)
{
    const int row = m_list->currentRow();
    m_answer = {.action = action, .offer = static_cast<std::size_t>(row < 0 ? 0 : row)};
    done(Accepted);
}

} // namespace berg
