#include "widgets/charts/value_table.h"

#include <QAbstractTableModel>
#include <QAction>
#include <QClipboard>
#include <QDialogButtonBox>
#include <QGuiApplication>
#include <QHeaderView>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr QSize kBest_px(560, 420);

/** Of texts that are made when they are wanted. */
class ValueModel final : public QAbstractTableModel
{
public:
    ValueModel(const ChartValues& values, QObject* parent)
        : QAbstractTableModel(parent), m_values(values)
    {
    }

    [[nodiscard]] int rowCount(const QModelIndex& parent) const override
    {
        return parent.isValid() ? 0 : m_values.rows;
    }
    [[nodiscard]] int columnCount(const QModelIndex& parent) const override
    {
        return parent.isValid() ? 0 : static_cast<int>(m_values.columns.size());
    }
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override
    {
        if (role == Qt::DisplayRole)
            return m_values.text(index.row(), index.column());
        return {};
    }
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role) const override
    {
        if (orientation == Qt::Horizontal && role == Qt::DisplayRole)
            return m_values.columns[section];
        return {};
    }

private:
    ChartValues m_values;
};

void copy(const ChartValues& values)
{
    QString text = values.columns.join(u'\t') + u'\n';
    for (int row = 0; row < values.rows; ++row)
        for (int column = 0; column < values.columns.size(); ++column)
            text += values.text(row, column) + (column + 1 < values.columns.size() ? u'\t' : u'\n');
    QGuiApplication::clipboard()->setText(text);
}

} // namespace

ValueTable::ValueTable(const ChartValues& values, QWidget* parent) : QDialog(parent)
{
    setObjectName(u"valueTable"_s);
    setWindowTitle(tr("Values: %1").arg(values.title));
    auto* column = new QVBoxLayout(this);
    auto* table = new QTableView;
    table->setObjectName(u"values"_s);
    table->setAccessibleName(values.title);
    table->setModel(new ValueModel(values, table));
    table->setTabKeyNavigation(false);
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->verticalHeader()->hide();
    table->resizeColumnsToContents();
    column->addWidget(table);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    QPushButton* copies = buttons->addButton(tr("Copy"), QDialogButtonBox::ActionRole);
    copies->setObjectName(u"copyValues"_s);
    connect(copies, &QPushButton::clicked, this, [values] { copy(values); });
    column->addWidget(buttons);
    resize(kBest_px);
    if (values.rows > 0)
        table->setCurrentIndex(table->model()->index(0, 0));
    table->setFocus();
}

void ValueTable::open(const ChartValues& values, QWidget* parent)
{
    auto* table = new ValueTable(values, parent);
    table->setAttribute(Qt::WA_DeleteOnClose);
    table->show();
}

QAction* addValueAction(QWidget& chart)
{
    auto* action = new QAction(ValueTable::tr("Show values as a table"), &chart);
    action->setShortcut(Qt::Key_V);
    action->setShortcutContext(Qt::WidgetShortcut);
    chart.addAction(action);
    return action;
}

} // namespace berg
