#pragma once

#include "tests/support/window/monkey_hand.h"
#include "tests/support/window/monkey_window.h"
#include "widgets/document/scenario_edits.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QAction>
#include <QDockWidget>
#include <QDropEvent>
#include <QFile>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QUndoStack>
#include <QWheelEvent>

#include <array>
#include <span>

namespace berg::test {

/**
 * A user without any plan, whose actions come in pieces: between a press and its release there may
 * be keys, a take-off, or an undo. The actions depend on the seed and their number; their places on
 * the present screen.
 */
class Monkey
{
public:
    Monkey(MonkeyWindow& window, std::uint64_t seed)
        : w(window), m_seed(seed), m_log(w.folder.filePath(u"actions.txt"_s))
    {
        if (!m_log.open(QIODevice::WriteOnly | QIODevice::Unbuffered))
            qFatal("no log of actions");
    }

    [[nodiscard]] QString logPath() const { return m_log.fileName(); }

    void act(int number)
    {
        static constexpr std::array kPressed{MonkeyAction{40, "move", &Monkey::move},
                                             MonkeyAction{30, "key", &Monkey::pressKeyInDrag},
                                             MonkeyAction{18, "release", &Monkey::release},
                                             MonkeyAction{12, "wait", &Monkey::wait}};
        static constexpr std::array kFree{MonkeyAction{24, "press", &Monkey::press},
                                          MonkeyAction{10, "click", &Monkey::click},
                                          MonkeyAction{2, "double click", &Monkey::doubleClick},
                                          MonkeyAction{2, "right click", &Monkey::rightClick},
                                          MonkeyAction{3, "wheel", &Monkey::turnWheel},
                                          MonkeyAction{18, "key", &Monkey::pressKey},
                                          MonkeyAction{7, "tool", &Monkey::chooseTool},
                                          MonkeyAction{4, "draw area", &Monkey::drawArea},
                                          MonkeyAction{8, "button", &Monkey::pressButton},
                                          MonkeyAction{5, "widget", &Monkey::pressWidget},
                                          MonkeyAction{4, "type", &Monkey::type},
                                          MonkeyAction{3, "cell", &Monkey::editCell},
                                          MonkeyAction{4, "action", &Monkey::triggerAction},
                                          MonkeyAction{2, "dock", &Monkey::raiseDock},
                                          MonkeyAction{1, "drop", &Monkey::dropFile},
                                          MonkeyAction{5, "wait", &Monkey::wait}};
        QTest::qWait(0); // handles events posted by the last action, e.g. for another window
        m_random = Random(m_seed, static_cast<std::uint64_t>(number));
        w.window().findChild<QAction*>(u"quitAction"_s)->setEnabled(false);
        const MonkeyAction& kind =
            m_isPressed ? any<MonkeyAction>(kPressed) : any<MonkeyAction>(kFree);
        log(u"%1 %2"_s.arg(number).arg(QLatin1String(kind.name)));
        m_hand.begin(w.window(), m_random.bits());
        (this->*kind.act)();
        if (m_hand.hasLetGo())
            m_isPressed = false;
    }

    /** Releases, closes and finishes everything. */
    void rest()
    {
        m_hand.begin(w.window(), m_random.bits());
        if (m_isPressed)
            release();
        while (QWidget* popup = QApplication::activePopupWidget())
            popup->close();
        w.workspace.study().cancel();
        w.workspace.benchmark().cancel();
        w.map().setFocus();
        for (int i = 0; i < 3; ++i)
            key(Qt::Key_Escape);
    }

private:
    struct MonkeyAction
    {
        std::uint64_t weight;
        const char* name;
        void (Monkey::*act)();
    };
    struct Keys
    {
        std::uint64_t weight;
        Qt::Key key;
        Qt::KeyboardModifiers modifiers;
    };

    [[nodiscard]] std::uint64_t below(std::uint64_t count) { return m_random.below(count); }
    [[nodiscard]] int between(int low, int high)
    {
        return low + static_cast<int>(below(static_cast<std::uint64_t>(high - low) + 1));
    }
    [[nodiscard]] bool chance(std::uint64_t percent) { return below(100) < percent; }
    template <class Weighted>
    [[nodiscard]] const Weighted& any(std::span<const Weighted> all)
    {
        std::uint64_t sum = 0;
        for (const Weighted& one : all)
            sum += one.weight;
        std::uint64_t at = below(sum);
        for (const Weighted& one : all) {
            if (at < one.weight)
                return one;
            at -= one.weight;
        }
        return all.back();
    }
    template <class Widget>
    [[nodiscard]] Widget* anyShown()
    {
        QList<Widget*> shown;
        for (Widget* widget : top().template findChildren<Widget*>())
            if (widget->isEnabled() && !widget->visibleRegion().isEmpty())
                shown << widget;
        return shown.isEmpty()
                   ? nullptr
                   : shown[static_cast<qsizetype>(below(static_cast<std::uint64_t>(shown.size())))];
    }
    /** Returns a visible window: usually the main one, else a floating dock. */
    [[nodiscard]] QWidget& top()
    {
        if (chance(80))
            return w.window();
        QWidgetList floating;
        for (auto* dock : w.window().findChildren<QDockWidget*>())
            if (dock->isFloating() && dock->isVisible())
                floating << dock;
        if (floating.isEmpty())
            return w.window();
        return *floating[static_cast<qsizetype>(
            below(static_cast<std::uint64_t>(floating.size())))];
    }
    void log(const QString& line) { m_log.write((line + u'\n').toUtf8()); }

    // Places.

    /** Returns pixels of the map with something to grab. */
    [[nodiscard]] std::vector<QPointF> spots()
    {
        std::vector<Point> spots_m;
        const Scenario& scenario = w.scenario();
        const std::vector<Point>& area_m = scenario.area_m;
        for (std::size_t i = 0; i < area_m.size(); ++i) {
            spots_m.push_back(area_m[i]);
            spots_m.emplace_back((area_m[i] + area_m[(i + 1) % area_m.size()]) / 2);
        }
        if (w.map().tools().kind() != MapToolKind::Area || area_m.empty()) {
            for (const Iceberg& iceberg : scenario.icebergs)
                spots_m.push_back(iceberg.position_m);
            for (const Uav& uav : scenario.uavs)
                spots_m.push_back(uav.position_m);
            if (scenario.asset)
                spots_m.push_back(scenario.asset->position_m);
        }
        std::vector<QPointF> spots;
        for (const Point& spot_m : spots_m)
            if (const QPointF at = w.map().toScreen(spot_m); QRectF(w.map().rect()).contains(at))
                spots.push_back(at);
        return spots;
    }
    /** Returns a place on the map, in pixels of the window. */
    [[nodiscard]] QPoint place()
    {
        const std::vector<QPointF> known = spots();
        const QRect map = w.map().rect();
        QPoint at(between(0, map.width() - 1), between(0, map.height() - 1));
        if (!known.empty() && chance(60))
            at = known[below(known.size())].toPoint() + QPoint(between(-2, 2), between(-2, 2));
        return onWindow(w.map(), at);
    }
    [[nodiscard]] static QPoint onWindow(const QWidget& widget, const QPoint& at)
    {
        const QWidget& window = *widget.window();
        const QPoint p = widget.mapTo(&window, at);
        return {std::clamp(p.x(), 1, window.width() - 2),
                std::clamp(p.y(), 1, window.height() - 2)};
    }
    [[nodiscard]] QPoint anywhereOn(const QWidget& widget)
    {
        const QRect rect = widget.visibleRegion().boundingRect();
        return onWindow(widget,
                        {between(rect.left(), rect.right()), between(rect.top(), rect.bottom())});
    }
    [[nodiscard]] QWindow* mainHandle() { return w.window().windowHandle(); }

    // Mouse.

    void pressAt(QWindow* window, const QPoint& at)
    {
        m_isPressed = true;
        m_pressedOn = window;
        m_pressedAt = at;
        QTest::mousePress(window, Qt::LeftButton, modifiers(), at);
    }
    [[nodiscard]] Qt::KeyboardModifiers modifiers()
    {
        if (chance(90))
            return {};
        return chance(50) ? Qt::ShiftModifier : Qt::ControlModifier;
    }
    void press() { pressAt(mainHandle(), place()); }
    [[nodiscard]] QPoint nearPress()
    {
        const QSize size = m_pressedOn->geometry().size();
        const QPoint at = m_pressedAt + QPoint(between(-120, 120), between(-120, 120));
        return {std::clamp(at.x(), 1, size.width() - 2), std::clamp(at.y(), 1, size.height() - 2)};
    }
    void move()
    {
        if (m_pressedOn != nullptr)
            QTest::mouseMove(m_pressedOn, nearPress());
        else
            release();
    }
    void release()
    {
        m_isPressed = false;
        if (m_pressedOn == nullptr) { // closed meanwhile
            m_pressedOn = mainHandle();
            m_pressedAt = {5, 5};
        }
        QTest::mouseRelease(m_pressedOn, Qt::LeftButton, {}, nearPress());
    }
    void click() { QTest::mouseClick(mainHandle(), Qt::LeftButton, modifiers(), place()); }
    void doubleClick() { QTest::mouseDClick(mainHandle(), Qt::LeftButton, {}, place()); }
    void rightClick() { QTest::mouseClick(mainHandle(), Qt::RightButton, {}, place()); }
    void turnWheel()
    {
        const QPoint at = place();
        QWidget* widget = w.window().childAt(at);
        if (widget == nullptr)
            return;
        QWheelEvent event(widget->mapFrom(&w.window(), at), w.window().mapToGlobal(at), {},
                          QPoint(0, chance(50) ? 120 : -120), Qt::NoButton, {}, Qt::NoScrollPhase,
                          false);
        QCoreApplication::sendEvent(widget, &event);
    }
    void pressWidget()
    {
        if (QWidget* widget = anyShown<QWidget>())
            pressAt(widget->window()->windowHandle(), anywhereOn(*widget));
    }
    void pressButton()
    {
        if (auto* button = anyShown<QAbstractButton>()) {
            log(u"  "_s + button->objectName() + u' ' + button->text());
            QTest::mouseClick(button->window()->windowHandle(), Qt::LeftButton, {},
                              anywhereOn(*button));
        }
    }
    void drawArea()
    {
        key(Qt::Key_R);
        const QPoint middle = place();
        const int corners = between(3, 5);
        for (int i = 0; i < corners; ++i) {
            const double angle_rad = 2 * M_PI * i / corners;
            const QPointF arm(std::cos(angle_rad), std::sin(angle_rad));
            QTest::mouseClick(mainHandle(), Qt::LeftButton, {},
                              onWindow(w.map(), w.map().mapFrom(&w.window(), middle) +
                                                    (arm * between(40, 150)).toPoint()));
        }
        key(Qt::Key_Return);
    }

    // Keys.

    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {})
    {
        QPointer<QWindow> window = QGuiApplication::focusWindow();
        if (window == nullptr)
            window = mainHandle();
        const char letter = modifiers == Qt::NoModifier ? QTest::keyToAscii(key) : '\0';
        const QString text = letter == '\0' ? QString() : QString(QLatin1Char(letter));
        // Unlike `keyClick`, this does not press modifiers on a window that may be gone by then.
        for (const bool isPress : {true, false})
            if (window != nullptr)
                QTest::simulateEvent(window, isPress, key, modifiers, text, false);
    }
    void pressAny(std::span<const Keys> all)
    {
        const Keys& keys = any(all);
        log(u"  "_s + QKeySequence(keys.key | keys.modifiers).toString());
        key(keys.key, keys.modifiers);
    }
    /** Presses a key that interferes with the current drag. */
    void pressKeyInDrag()
    {
        static constexpr std::array kKeys{Keys{8, Qt::Key_Z, Qt::ControlModifier},
                                          Keys{6, Qt::Key_Space, {}},
                                          Keys{2, Qt::Key_Y, Qt::ControlModifier},
                                          Keys{2, Qt::Key_Escape, {}},
                                          Keys{2, Qt::Key_Delete, {}},
                                          Keys{2, Qt::Key_Tab, {}},
                                          Keys{1, Qt::Key_Period, {}},
                                          Keys{1, Qt::Key_S, {}},
                                          Keys{1, Qt::Key_R, {}},
                                          Keys{1, Qt::Key_A, Qt::ControlModifier},
                                          Keys{1, Qt::Key_V, Qt::ControlModifier},
                                          Keys{1, Qt::Key_D, Qt::ControlModifier},
                                          Keys{1, Qt::Key_N, Qt::ControlModifier},
                                          Keys{1, Qt::Key_S, Qt::ControlModifier},
                                          Keys{1, Qt::Key_O, Qt::ControlModifier},
                                          Keys{1, Qt::Key_E, Qt::ControlModifier},
                                          Keys{1, Qt::Key_Left, {}},
                                          Keys{1, Qt::Key_Backspace, {}},
                                          Keys{1, Qt::Key_Return, {}},
                                          Keys{1, Qt::Key_Home, Qt::ControlModifier}};
        pressAny(kKeys);
    }
    void pressKey()
    {
        static constexpr std::array kKeys{Keys{8, Qt::Key_Z, Qt::ControlModifier},
                                          Keys{3, Qt::Key_Y, Qt::ControlModifier},
                                          Keys{4, Qt::Key_Space, {}},
                                          Keys{3, Qt::Key_Home, Qt::ControlModifier},
                                          Keys{2, Qt::Key_Period, {}},
                                          Keys{2, Qt::Key_Comma, {}},
                                          Keys{1, Qt::Key_Left, Qt::ControlModifier},
                                          Keys{1, Qt::Key_Right, Qt::ControlModifier},
                                          Keys{1, Qt::Key_End, Qt::ControlModifier},
                                          Keys{1, Qt::Key_T, Qt::ControlModifier},
                                          Keys{1, Qt::Key_Right, Qt::AltModifier},
                                          Keys{2, Qt::Key_Delete, {}},
                                          Keys{2, Qt::Key_Escape, {}},
                                          Keys{3, Qt::Key_Tab, {}},
                                          Keys{1, Qt::Key_Backtab, Qt::ShiftModifier},
                                          Keys{2, Qt::Key_Return, {}},
                                          Keys{1, Qt::Key_Backspace, {}},
                                          Keys{2, Qt::Key_Up, {}},
                                          Keys{2, Qt::Key_Down, {}},
                                          Keys{1, Qt::Key_Left, Qt::ShiftModifier},
                                          Keys{1, Qt::Key_A, Qt::ControlModifier},
                                          Keys{1, Qt::Key_C, Qt::ControlModifier},
                                          Keys{1, Qt::Key_X, Qt::ControlModifier},
                                          Keys{1, Qt::Key_V, Qt::ControlModifier},
                                          Keys{1, Qt::Key_D, Qt::ControlModifier},
                                          Keys{1, Qt::Key_U, Qt::ControlModifier},
                                          Keys{1, Qt::Key_N, Qt::ControlModifier},
                                          Keys{1, Qt::Key_O, Qt::ControlModifier},
                                          Keys{2, Qt::Key_S, Qt::ControlModifier},
                                          Keys{1, Qt::Key_R, Qt::ControlModifier},
                                          Keys{1, Qt::Key_E, Qt::ControlModifier},
                                          Keys{1, Qt::Key_I, Qt::ControlModifier},
                                          Keys{1, Qt::Key_BracketRight, {}},
                                          Keys{1, Qt::Key_N, {}},
                                          Keys{1, Qt::Key_W, {}},
                                          Keys{1, Qt::Key_F, {}},
                                          Keys{1, Qt::Key_L, {}},
                                          Keys{1, Qt::Key_F7, {}},
                                          Keys{1, Qt::Key_Question, {}}};
        pressAny(kKeys);
    }
    void chooseTool()
    {
        static constexpr std::array kKeys{Keys{2, Qt::Key_S, {}}, Keys{2, Qt::Key_I, {}},
                                          Keys{1, Qt::Key_U, {}}, Keys{1, Qt::Key_A, {}},
                                          Keys{3, Qt::Key_R, {}}, Keys{1, Qt::Key_M, {}},
                                          Keys{1, Qt::Key_H, {}}};
        pressAny(kKeys);
    }

    // Fields, actions, files.

    void write()
    {
        static constexpr std::array kTexts{"0", "1", "-5", "12.5", "1e9", "0.001", "abc", "", "90"};
        key(Qt::Key_A, Qt::ControlModifier);
        for (const char letter : std::string_view(kTexts[below(kTexts.size())]))
            QTest::keyClick(mainHandle(), letter);
        static constexpr std::array kEnds{Qt::Key_Return, Qt::Key_Tab, Qt::Key_Escape};
        if (chance(80))
            key(kEnds[below(kEnds.size())]);
    }
    void type()
    {
        QWidget* field = chance(50) ? static_cast<QWidget*>(anyShown<QAbstractSpinBox>())
                                    : static_cast<QWidget*>(anyShown<QLineEdit>());
        if (field == nullptr || field->window() != &w.window())
            return;
        QTest::mouseClick(mainHandle(), Qt::LeftButton, {}, anywhereOn(*field));
        write();
    }
    void editCell()
    {
        auto* view = anyShown<QAbstractItemView>();
        if (view == nullptr || view->model() == nullptr || view->window() != &w.window())
            return;
        const int rows = view->model()->rowCount();
        const int columns = view->model()->columnCount();
        if (rows == 0 || columns == 0)
            return;
        const QModelIndex cell =
            view->model()->index(between(0, rows - 1), between(0, columns - 1));
        view->scrollTo(cell);
        QTest::mouseDClick(mainHandle(), Qt::LeftButton, {},
                           onWindow(*view->viewport(), view->visualRect(cell).center()));
        write();
    }
    void triggerAction()
    {
        QList<QAction*> actions;
        for (auto* action : w.window().findChildren<QAction*>())
            if (action->isEnabled() && !action->objectName().isEmpty())
                actions << action;
        QAction* action =
            actions[static_cast<qsizetype>(below(static_cast<std::uint64_t>(actions.size())))];
        if (action->objectName().contains(u"view/"_s) && chance(80))
            return; // it makes another window
        log(u"  "_s + action->objectName());
        action->trigger();
    }
    void raiseDock()
    {
        const auto docks = w.window().findChildren<QDockWidget*>();
        QDockWidget* dock =
            docks[static_cast<qsizetype>(below(static_cast<std::uint64_t>(docks.size())))];
        dock->show();
        dock->raise();
    }
    void dropFile()
    {
        QMimeData data;
        const QString path = w.interaction.anyFile();
        log(u"  "_s + path);
        data.setUrls({QUrl::fromLocalFile(path)});
        const QPoint at = w.window().rect().center();
        QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&w.window(), &enter);
        QDropEvent drop(at, Qt::CopyAction, &data, Qt::LeftButton, {});
        if (enter.isAccepted())
            QCoreApplication::sendEvent(&w.window(), &drop);
    }
    void wait()
    {
        constexpr int kPlan_ms = 500;
        if (chance(50))
            (void)w.untilAnswered(kPlan_ms);
        else
            QTest::qWait(between(0, 40));
    }

    MonkeyWindow& w;
    std::uint64_t m_seed;
    Random m_random{0};
    QFile m_log;
    Hand m_hand;
    bool m_isPressed = false;
    QPointer<QWindow> m_pressedOn;
    QPoint m_pressedAt; ///< in pixels of that window
};

} // namespace berg::test
