#include "widgets/panels/fields/entry_field.h"

#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace berg {

void settleTyping(QLineEdit& line)
{
    if (!line.isModified())
        return;
    const int cursor = line.cursorPosition();
    line.setText(line.text()); // clears the undo history
    line.setCursorPosition(cursor);
}

void setLockedStyle(QWidget& input, bool locked)
{
    QPalette colours;
    if (locked)
        colours.setColor(QPalette::Base, QApplication::palette().color(QPalette::Window));
    input.setPalette(colours);
}

EntryField::EntryField(const EntryWords& words, ValidationTime when,
                       std::function<QString(const QString&)> faultOf, QWidget* parent)
    : QWidget(parent)
    , m_faultOf(std::move(faultOf))
    , m_line(new QLineEdit(this))
    , m_fault(new QLabel(this))
{
    m_line->setObjectName(words.key);
    m_line->setAccessibleName(words.label);
    m_line->setToolTip(words.toolTip);
    m_fault->setObjectName(words.key + u"Fault"_s);
    m_fault->setWordWrap(true);
    m_fault->hide();
    setFocusProxy(m_line);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    column->addWidget(m_line);
    column->addWidget(m_fault);
    connect(m_line, &QLineEdit::textEdited, this, [this, when](const QString& text) {
        const bool isJudged = when == ValidationTime::AtOnce && text != m_shown;
        say(isJudged ? m_faultOf(text) : QString());
    });
    connect(m_line, &QLineEdit::editingFinished, this, &EntryField::finishTyping);
}

void EntryField::showText(const QString& text, const QString& placeholder)
{
    m_line->setPlaceholderText(placeholder);
    if (text == m_shown)
        return;
    m_shown = text;
    m_line->setText(text);
    m_line->setCursorPosition(0);
    say({});
}

void EntryField::setLocked(bool locked)
{
    m_line->setReadOnly(locked);
    setLockedStyle(*m_line, locked);
}

void EntryField::finishTyping()
{
    settleTyping(*m_line);
    const QString text = m_line->text();
    if (text == m_shown)
        return;
    const QString fault = m_faultOf(text);
    if (fault.isEmpty()) {
        m_shown = text;
        say({});
        emit edited(text);
        return;
    }
    m_line->setText(m_shown);
    say(fault); // stays until the next typing
}

void EntryField::say(const QString& fault)
{
    m_fault->setText(fault);
    m_fault->setAccessibleName(fault);
    m_fault->setVisible(!fault.isEmpty());
}

} // namespace berg
