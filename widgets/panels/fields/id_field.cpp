#include "widgets/panels/fields/id_field.h"

#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace berg {

IdField::IdField(const IdWords& words, std::function<QString(const QString&)> whyNot,
                 QWidget* parent)
    : QWidget(parent)
    , m_whyNot(std::move(whyNot))
    , m_line(new QLineEdit(this))
    , m_fault(new QLabel(this))
{
    m_line->setObjectName(words.key + u"Id"_s);
    m_line->setAccessibleName(tr("Id"));
    m_line->setToolTip(words.toolTip);
    m_fault->setObjectName(words.key + u"IdFault"_s);
    m_fault->setWordWrap(true);
    m_fault->hide();
    setFocusProxy(m_line);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    column->addWidget(m_line);
    column->addWidget(m_fault);
    connect(m_line, &QLineEdit::textEdited, this,
            [this](const QString& text) { say(text == m_id ? QString() : m_whyNot(text)); });
    connect(m_line, &QLineEdit::editingFinished, this, &IdField::finishTyping);
}

void IdField::showId(const QString& id)
{
    if (id == m_id)
        return;
    m_id = id;
    m_line->setText(id);
    say({});
}

void IdField::setLocked(bool locked)
{
    m_line->setReadOnly(locked);
    QPalette colours;
    if (locked)
        colours.setColor(QPalette::Base, m_line->palette().color(QPalette::Window));
    m_line->setPalette(colours);
}

void IdField::finishTyping()
{
    const QString text = m_line->text();
    if (text == m_id)
        return;
    const QString fault = m_whyNot(text);
    if (fault.isEmpty()) {
        m_id = text;
        say({});
        emit edited(text);
        return;
    }
    m_line->setText(m_id); // the reason stays until the next typing
}

void IdField::say(const QString& fault)
{
    m_fault->setText(fault);
    m_fault->setAccessibleName(fault);
    m_fault->setVisible(!fault.isEmpty());
}

} // namespace berg
