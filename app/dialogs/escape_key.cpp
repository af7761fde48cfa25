#include "app/dialogs/escape_key.h"

#include <QApplication>
#include <QDialog>
#include <QKeyEvent>
#include <QShortcut>

namespace berg {

namespace {

/** Takes the key from the shortcut while a list is open: the list hides before shortcuts are tried.
 */
class OpenListFirst final : public QObject
{
public:
    using QObject::QObject;

    bool eventFilter(QObject* /*watched*/, QEvent* event) override
    {
        if (event->type() != QEvent::ShortcutOverride ||
            static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape ||
            QApplication::activePopupWidget() == nullptr)
            return false;
        event->accept();
        return true;
    }
};

} // namespace

void closeOnEscape(QDialog& dialog)
{
    auto* escape = new QShortcut(Qt::Key_Escape, &dialog);
    QObject::connect(escape, &QShortcut::activated, &dialog, &QDialog::reject);
    qApp->installEventFilter(new OpenListFirst(&dialog));
}

} // namespace berg
