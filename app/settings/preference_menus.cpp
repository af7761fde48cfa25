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

void PreferenceMenus::build(QMenu& menu)
{
    buildAppearance(*menu.addMenu(tr("&Appearance")));
    buildScale(*menu.addMenu(tr("Text si&ze")));
    buildUnits(*menu.addMenu(tr("U&nits")));
    buildLanguage(*menu.addMenu(tr("&Language")));
}

void PreferenceMenus::addChoice(QMenu& menu, const QString& text, const QString& key,
                                const QString& value)
{
    auto* group = menu.findChild<QActionGroup*>();
    if (group == nullptr)
        group = new QActionGroup(&menu);
    QAction* action = group->addAction(text);
    action->setCheckable(true);
    action->setData(value);
    action->setObjectName(key + u'-' + value);
    const QString first = group->actions().front()->data().toString();
    action->setChecked(value == settings().value(key, first).toString());
    menu.addAction(action);
}

void PreferenceMenus::buildAppearance(QMenu& menu)
{
    const QStringList words{
        tr("Follow system"),       tr("Light"),      tr("Dark"), tr("High contrast, light"),
        tr("High contrast, dark"), tr("Night (red)")};
    for (qsizetype i = 0; i < words.size(); ++i)
        addChoice(menu, words[i], u"view/appearance"_s, QString::number(i));
    connect(&menu, &QMenu::triggered, &m_appearance, [this](const QAction* action) {
        m_appearance.setAppearance(static_cast<Appearance>(action->data().toInt()));
    });
}

/** Scales the whole window, because larger text alone would not fit. */
void PreferenceMenus::buildScale(QMenu& menu)
{
    for (const int scale_percent : kScales_percent)
        addChoice(menu, u"%1 %"_s.arg(scale_percent), QLatin1String(kScaleKey),
                  QString::number(scale_percent));
    connect(&menu, &QMenu::triggered, this, [this](const QAction* action) {
        settings().setValue(kScaleKey, action->data());
        showMessage(tr("Restart Bergwatch to apply the new text size."), kLongMessage_ms);
    });
}

void PreferenceMenus::buildSigmaEnd(QMenu& menu)
{
    addChoice(menu, tr("Automatic, from the scenario"), QLatin1String(kSigmaEndKey), u"0"_s);
    for (const int end_m2 : {5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10'000})
        addChoice(menu, tr("Ends at %1 m²").arg(locale().toString(end_m2)),
                  QLatin1String(kSigmaEndKey), QString::number(end_m2));
    connect(&menu, &QMenu::triggered, this, [this](const QAction* action) {
        settings().setValue(kSigmaEndKey, action->data());
        chooseSigmaEnd(readSigmaEnd_m2(settings()));
        emit sigmaEndChosen();
    });
}

void PreferenceMenus::buildUnits(QMenu& menu)
{
    const auto choices = [&](const QString& title, const char* key,
                             const std::vector<std::pair<QString, QString>>& values) {
        QMenu& choice = *menu.addMenu(title);
        for (const auto& [value, text] : values)
            addChoice(choice, text, QLatin1String(key), value);
        connect(&choice, &QMenu::triggered, this, [this, key](QAction* action) {
            settings().setValue(key, action->data());
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
    const QLatin1String key(kNorthFormKey);
    const double typed_deg = readDeclination_deg(settings());
    addChoice(menu, tr("True"), key, u"true"_s);
    addChoice(menu, tr("True and magnetic, by the World Magnetic Model 2025"), key, u"model"_s);
    addChoice(
        menu,
        shownUnits().north == NorthForm::Typed
            ? tr("True and magnetic, declination %1...").arg(declinationText(typed_deg, locale()))
            : tr("True and magnetic, declination entered by hand..."),
        key, u"typed"_s);
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
    for (const SightingSource source : kSightingSources)
        addChoice(menu, sourceText(source, locale()), QLatin1String(kSourceKey),
                  QString::fromUtf8(errorOf(source).name.data()));
    connect(&menu, &QMenu::triggered, this, [&document](const QAction* action) {
        if (const auto source = sourceNamed(action->data().toString().toStdString()))
            document.setNewIcebergSource(*source);
    });
    connect(&document, &ScenarioDocument::newIcebergSourceChanged, &menu,
            [this, &menu](SightingSource source) {
                const QString name = QString::fromUtf8(errorOf(source).name.data());
                settings().setValue(kSourceKey, name);
                for (QAction* action : menu.actions())
                    if (action->data().toString() == name)
                        action->setChecked(true);
            });
}

void PreferenceMenus::buildLanguage(QMenu& menu)
{
    addChoice(menu, tr("Follow system"), u"view/language"_s, u""_s);
    addChoice(menu, u"English"_s, u"view/language"_s, u"en"_s);
    addChoice(menu, u"Dansk"_s, u"view/language"_s, u"da"_s);
    addChoice(menu, u"Français"_s, u"view/language"_s, u"fr"_s);
    addChoice(menu, u"Norsk bokmål"_s, u"view/language"_s, u"nb"_s);
    connect(&menu, &QMenu::triggered, this, [this](const QAction* action) {
        settings().setValue("view/language", action->data());
        const QString language = action->data().toString();
        emit languageChosen(language.isEmpty() ? std::nullopt : std::optional(language));
    });
}

} // namespace berg
