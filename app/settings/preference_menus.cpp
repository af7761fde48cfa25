#include "app/settings/preference_menus.h"

#include "app/dialogs/interaction.h"
#include "app/settings/appearance_choice.h"
#include "app/settings/run_settings.h"
#include "core/earth/coordinates.h"
#include "widgets/flight/sigma_end.h"
#include "widgets/theme/declination.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/theme/unit_settings.h"
#include "widgets/words/source_text.h"
#include "widgets/workspace/workspace.h"

#include <QActionGroup>
#include <QMainWindow>
#include <QMenu>
#include <QSettings>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr const char* kSourceKey = "icebergs/source"; ///< radar, visual, satellite ...

} // namespace

PreferenceMenus::PreferenceMenus(WindowContext& context, AppearanceChoice& appearance)
    : WindowPart(context), m_appearance(appearance)
{
    useSavedSource();
}

void PreferenceMenus::addChoices(QMenu& menu, const char* key, const Choices& choices)
{
    auto* group = new QActionGroup(&menu);
    const QString present = settings().value(key, choices.front().first).toString();
    for (const auto& [value, text] : choices) {
        QAction* action = group->addAction(text);
        action->setCheckable(true);
        action->setData(value);
        action->setObjectName(QLatin1String(key) + u'-' + value);
        action->setChecked(value == present);
    }
    menu.addActions(group->actions());
}

template <class Chosen>
void PreferenceMenus::addChoices(QMenu& menu, const char* key, const Choices& choices,
                                 const Chosen& chosen)
{
    addChoices(menu, key, choices);
    connect(&menu, &QMenu::triggered, this, [this, key, chosen](const QAction* action) {
        settings().setValue(key, action->data());
        chosen(action->data().toString());
    });
}

void PreferenceMenus::build(QMenu& menu)
{
    addChoices(*menu.addMenu(tr("&Appearance")), "view/appearance",
               {{u"0"_s, tr("Follow system")},
                {u"1"_s, tr("Light")},
                {u"2"_s, tr("Dark")},
                {u"3"_s, tr("High contrast, light")},
                {u"4"_s, tr("High contrast, dark")},
                {u"5"_s, tr("Night (red)")}},
               [this](const QString& value) {
                   m_appearance.setAppearance(static_cast<Appearance>(value.toInt()));
               });
    Choices scales; // of the whole window, because larger text alone would not fit
    for (const int scale_percent : kScales_percent)
        scales.emplace_back(QString::number(scale_percent), u"%1 %"_s.arg(scale_percent));
    addChoices(*menu.addMenu(tr("Text si&ze")), kScaleKey, scales, [this](const QString&) {
        showMessage(tr("Restart Bergwatch to apply the new text size."), kLongMessage_ms);
    });
    buildUnits(*menu.addMenu(tr("U&nits")));
    addChoices(*menu.addMenu(tr("&Language")), "view/language",
               {{u""_s, tr("Follow system")},
                {u"en"_s, u"English"_s},
                {u"da"_s, u"Dansk"_s},
                {u"fr"_s, u"Français"_s},
                {u"nb"_s, u"Norsk bokmål"_s}},
               [this](const QString& language) {
                   emit languageChosen(language.isEmpty() ? std::nullopt : std::optional(language));
               });
}

void PreferenceMenus::buildSigmaEnd(QMenu& menu)
{
    menu.setObjectName(u"sigmaEndMenu"_s);
    Choices ends{{u"0"_s, tr("Automatic, from the scenario")}};
    for (const int end_m2 : {5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10'000})
        ends.emplace_back(QString::number(end_m2),
                          tr("Ends at %1 m²").arg(locale().toString(end_m2)));
    addChoices(menu, kSigmaEndKey, ends, [this](const QString&) {
        chooseSigmaEnd(readSigmaEnd_m2(settings()));
        emit sigmaEndChosen();
    });
}

void PreferenceMenus::buildUnits(QMenu& menu)
{
    const auto choices = [&](const QString& title, const char* key, const Choices& values) {
        addChoices(*menu.addMenu(title), key, values, [this](const QString&) {
            if (readUnits(settings()) != shownUnits())
                emit unitsChosen();
        });
    };
    choices(tr("&Distances"), kDistanceUnitKey,
            {{u"metric"_s, tr("Metres and kilometres")}, {u"nautical"_s, tr("Nautical miles")}});
    choices(tr("&Heights"), kHeightUnitKey, {{u"metres"_s, tr("Metres")}, {u"feet"_s, tr("Feet")}});
    choices(tr("&Speeds"), kSpeedUnitKey,
            {{u"mps"_s, tr("Metres per second")}, {u"knots"_s, tr("Knots")}});
    buildNorth(*menu.addMenu(tr("C&ourses")));
    choices(tr("Drift and &wind"), kVectorFormKey,
            {{u"direction"_s, tr("Speed and direction: wind from, drift towards")},
             {u"components"_s, tr("Components east and north")}});
    choices(tr("&Times"), kTimeFormKey,
            {{u"utc"_s, tr("UTC, if the scenario has a start time")},
             {u"elapsed"_s, tr("Elapsed since the start")}});
    choices(tr("&Uncertainty"), kUncertaintyFormKey,
            {{u"sigma"_s, tr("σ first, 95 % radius beside it")},
             {u"radius"_s, tr("95 % radius first, σ beside it")}});
    constexpr double kExample_deg = 47.05;
    const auto form = [&](CoordinateForm one) {
        return QString::fromStdString(angleText(kExample_deg, one, 2))
            .replace(u'.', locale().decimalPoint());
    };
    choices(
        tr("&Coordinates"), kCoordinateFormKey,
        {{u"minutes"_s, tr("Degrees and minutes, %1").arg(form(CoordinateForm::DegreesMinutes))},
         {u"decimal"_s, tr("Decimal degrees, %1").arg(form(CoordinateForm::DecimalDegrees))},
         {u"seconds"_s,
          tr("Degrees, minutes, seconds, %1").arg(form(CoordinateForm::DegreesMinutesSeconds))}});
}

void PreferenceMenus::buildNorth(QMenu& menu)
{
    const QString typed = declinationText(readDeclination_deg(settings()), locale());
    addChoices(menu, kNorthFormKey,
               {{u"true"_s, tr("True")},
                {u"model"_s, tr("True and magnetic, by the World Magnetic Model 2025")},
                {u"typed"_s, shownUnits().north == NorthForm::Typed
                                 ? tr("True and magnetic, declination %1...").arg(typed)
                                 : tr("True and magnetic, declination entered by hand...")}});
    connect(&menu, &QMenu::triggered, this,
            [this](const QAction* action) { chooseNorth(*action); });
}

/** Asks for a declination where it is typed in; without an answer nothing changes. */
void PreferenceMenus::chooseNorth(const QAction& action)
{
    const QLatin1String key(kNorthFormKey);
    if (action.data().toString() == u"typed"_s) {
        const std::optional<double> typed_deg =
            interaction().askDeclination(&window(), readDeclination_deg(settings()));
        if (!typed_deg) {
            const QString present = settings().value(key, u"true"_s).toString();
            for (QAction* other : action.actionGroup()->actions())
                other->setChecked(other->data().toString() == present);
            return;
        }
        settings().setValue(kDeclinationKey, *typed_deg);
    }
    settings().setValue(key, action.data());
    if (readUnits(settings()) != shownUnits() ||
        readDeclination_deg(settings()) != typedDeclination_deg())
        emit unitsChosen();
}

void PreferenceMenus::useSavedSource()
{
    const std::string name = settings().value(kSourceKey).toString().toStdString();
    workspace().document().setNewIcebergSource(sourceNamed(name).value_or(kSightingSources[0]));
}

void PreferenceMenus::buildSources(QMenu& menu)
{
    ScenarioDocument& document = workspace().document();
    const auto nameOf = [](SightingSource source) {
        return QString::fromUtf8(errorOf(source).name.data());
    };
    Choices sources;
    for (const SightingSource source : kSightingSources)
        sources.emplace_back(nameOf(source), sourceText(source, locale()));
    addChoices(menu, kSourceKey, sources, [&document](const QString& name) {
        if (const auto source = sourceNamed(name.toStdString()))
            document.setNewIcebergSource(*source);
    });
    connect(&document, &ScenarioDocument::newIcebergSourceChanged, &menu,
            [this, &menu, nameOf](SightingSource source) {
                settings().setValue(kSourceKey, nameOf(source));
                for (QAction* action : menu.actions())
                    if (action->data().toString() == nameOf(source))
                        action->setChecked(true);
            });
}

} // namespace berg
