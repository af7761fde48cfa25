#pragma once

#include "app/layout/window_part.h"

#include <optional>
#include <utility>
#include <vector>

class QAction;
class QMenu;

namespace berg {

class AppearanceChoice;

/** Menus in which one of several choices is in force: appearance, units, language. */
class PreferenceMenus : public WindowPart
{
    Q_OBJECT

public:
    PreferenceMenus(WindowContext& context, AppearanceChoice& appearance);

    void build(QMenu& menu);
    /** Fills a menu that chooses where the colours of sigma end, by scenario or for all of them. */
    void buildSigmaEnd(QMenu& menu);
    /** Fills a menu that chooses what sees new icebergs, and so how uncertain they are. */
    void buildSources(QMenu& menu);

signals:
    /** Emitted when a language was chosen; nullopt is the system's. */
    void languageChosen(const std::optional<QString>& language);
    void unitsChosen();
    void sigmaEndChosen();

private:
    using Choices = std::vector<std::pair<QString, QString>>; ///< value and text; default first

    void addChoices(QMenu& menu, const char* key, const Choices& choices);
    /** `chosen` follows when the value is in the settings. */
    template <class Chosen>
    void addChoices(QMenu& menu, const char* key, const Choices& choices, const Chosen& chosen);
    void buildUnits(QMenu& menu);
    void buildNorth(QMenu& menu);
    void chooseNorth(const QAction& action);
    void useSavedSource();

    AppearanceChoice& m_appearance;
};

} // namespace berg
