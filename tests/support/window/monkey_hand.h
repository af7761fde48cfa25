#pragma once

#include "core/base/random.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QMenu>
#include <QPointer>
#include <QTimer>
#include <QtTest>

namespace berg::test {

/**
 * While it exists, it uses modal windows at random and closes them, and ends menus and drags
 * between widgets, whose event loops block the caller.
 */
class Hand
{
public:
    Hand()
    {
        m_clock.start();
        handleAgain();
    }

    /** Begins acting on this window. */
    void begin(QWidget& window, std::uint64_t seed)
    {
        m_window = &window;
        m_random = Random(seed);
        m_hasLetGo = false;
        m_clock.restart();
    }

    /** Returns whether the pressed button has been released. */
    [[nodiscard]] bool hasLetGo() const { return m_hasLetGo; }

private:
    static constexpr int kTurn_ms = 2;
    static constexpr int kMenu_ms = 100;
    static constexpr int kStuck_ms = 3000;
    static constexpr int kPatience = 60; ///< turns until a dialog is simply closed

    /**
     * Uses a new timer each time: a repeating one does not fire in the event loop of a dialog that
     * it opened.
     */
    void handleAgain()
    {
        QTimer::singleShot(kTurn_ms, &m_alive, [this] {
            handleAgain();
            handleFront();
        });
    }

    void handleFront()
    {
        QWidget* front = QApplication::activeModalWidget();
        if (m_clock.elapsed() > kMenu_ms && QApplication::activePopupWidget() != nullptr)
            front = QApplication::activePopupWidget();
        if (front == nullptr) {
            if (m_clock.elapsed() > kStuck_ms && m_window != nullptr && !m_hasLetGo)
                letGo();
            return;
        }
        if (front == m_usedNow)
            return; // already acting
        const QPointer<QWidget> before = m_usedNow;
        m_usedNow = front;
        if (auto* menu = qobject_cast<QMenu*>(front))
            choose(*menu);
        else
            use(*front);
        m_usedNow = before;
        m_clock.restart();
    }

    void letGo()
    {
        m_hasLetGo = true;
        QTest::mouseRelease(m_window->windowHandle(), Qt::LeftButton, {}, {5, 5});
    }

    void choose(QMenu& menu)
    {
        if (m_random.below(4) == 0 || menu.windowHandle() == nullptr)
            menu.close();
        else
            QTest::keyClick(menu.windowHandle(),
                            m_random.below(3) == 0 ? Qt::Key_Return : Qt::Key_Down);
    }

    void use(QWidget& modal)
    {
        if (&modal != m_last) {
            m_last = &modal;
            m_turns = 0;
        }
        auto* dialog = qobject_cast<QDialog*>(&modal);
        if (++m_turns > kPatience || qobject_cast<QFileDialog*>(&modal) != nullptr) {
            if (dialog != nullptr)
                dialog->reject();
            else
                modal.close();
            return;
        }
        QWindow* handle = modal.windowHandle();
        QList<QWidget*> shown;
        for (auto* child : modal.findChildren<QWidget*>())
            if (child->isEnabled() && !child->visibleRegion().isEmpty())
                shown << child;
        if (handle == nullptr || shown.isEmpty())
            return;
        static constexpr Qt::Key kKeys[] = {Qt::Key_Tab,  Qt::Key_Return, Qt::Key_Escape,
                                            Qt::Key_Down, Qt::Key_Up,     Qt::Key_Space,
                                            Qt::Key_1,    Qt::Key_Delete};
        if (m_random.below(2) == 0) {
            QTest::keyClick(handle, kKeys[m_random.below(std::size(kKeys))]);
            return;
        }
        const QWidget& child = *shown[static_cast<qsizetype>(
            m_random.below(static_cast<std::uint64_t>(shown.size())))];
        const QPoint at = child.mapTo(&modal, child.visibleRegion().boundingRect().center());
        QTest::mouseClick(handle, Qt::LeftButton, {}, at);
    }

    QPointer<QWidget> m_window;
    Random m_random{0};
    QObject m_alive; ///< ends the checks with this object
    QElapsedTimer m_clock;
    QPointer<QWidget> m_usedNow;
    QPointer<QWidget> m_last;
    int m_turns = 0;
    bool m_hasLetGo = false;
};

} // namespace berg::test
