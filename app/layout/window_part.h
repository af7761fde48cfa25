#pragma once

#include "widgets/theme/theme.h"

#include <QLocale>
#include <QObject>

#include <functional>
#include <utility>

class QMainWindow;
class QSettings;

namespace berg {

class Interaction;
class Workspace;
struct Panels;

/** Shared objects of all parts of a window; they outlive the parts. */
struct WindowContext
{
    QMainWindow& window; ///< parent of dialogs; its status bar shows messages
    Workspace& workspace;
    Interaction& interaction;
    QSettings& settings;
    const Panels& panels;
    Theme theme;
    QObject life{nullptr}; ///< receiver of what is connected for the parts; ends before the panels

    /** Connects a signal with a function that may use all of these. */
    template <class Sender, class Signal, class Slot>
    void on(const Sender* sender, Signal signal, Slot slot)
    {
        QObject::connect(sender, signal, &life, std::move(slot));
    }
};

inline constexpr int kMessage_ms = 4000;
inline constexpr int kLongMessage_ms = 8000; ///< to read why something was not done
/** In the status bar, the list of messages, and to screen readers. */
void showMessage(const WindowContext& context, const QString& text, int duration_ms);

/** A part of the window that owns the state of one idea. GUI thread. */
class WindowPart : public QObject
{
protected:
    explicit WindowPart(WindowContext& context) : m_context(context) {}

    [[nodiscard]] WindowContext& context() const { return m_context; }
    [[nodiscard]] QMainWindow& window() const { return m_context.window; }
    /** Returns the parent for dialogs about a panel: its own window if it floats. */
    [[nodiscard]] QWidget* windowOf(const QWidget& panel) const;
    [[nodiscard]] Workspace& workspace() const { return m_context.workspace; }
    [[nodiscard]] Interaction& interaction() const { return m_context.interaction; }
    [[nodiscard]] QSettings& settings() const { return m_context.settings; }
    [[nodiscard]] const Panels& panels() const { return m_context.panels; }
    [[nodiscard]] const Theme& theme() const { return m_context.theme; }
    [[nodiscard]] QLocale locale() const;
    void showMessage(const QString& text, int duration_ms) const
    {
        berg::showMessage(m_context, text, duration_ms);
    }
    /** In the list of messages, and to screen readers. */
    void announce(const QString& text) const;
    /** Does the work, or shows what `Error` ends it: false then. */
    bool attempt(const std::function<void()>& work) const;

private:
    WindowContext& m_context;
};

} // namespace berg
