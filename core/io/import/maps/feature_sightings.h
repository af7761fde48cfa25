#pragma once

// Private to core/io: the step from the features of a map file to sightings, for every format.

#include "core/io/import/fields/feature_scene.h"
#include "core/io/import/fields/import_fields.h"
#include "core/io/import/fields/import_source.h"

#include <string>
#include <utility>
#include <vector>

namespace berg {

/** Kinds of geometries that a feature has. */
struct GeometryKinds
{
    bool tracks = false; ///< places with a time each
    bool points = false;
    bool areas = false;
    bool lines = false; ///< without times
};

/**
 * Collects the sightings and the scene of a map file. A reader calls `begin`, sets the properties
 * of the feature and adds its places, feature by feature. In a Bergwatch export only icebergs and
 * features of no kind become sightings.
 */
class FeatureSightings
{
public:
    /** `place` is the unit of lines in findings, as in `Rejections::place`. */
    explicit FeatureSightings(const ImportText& source, std::string_view place = "line");

    [[nodiscard]] bool isOwn() const { return m_isOwn; }
    /** Begins a feature without properties in a Bergwatch export, if `isOwn`, or another file. */
    void begin(std::size_t line, bool isOwn);
    /**
     * Begins a feature with its properties, name and id. Returns true if an id is among the
     * properties and the name.
     */
    bool begin(const FileFeature& feature);
    /** Sets a property that may be a field of a sighting. The geometry determines the place. */
    void setProperty(const std::string& name, const std::string& text);
    /**
     * Sets the members of an object (may be null). A pair becomes the components of a vector; a
     * value in an object that states its type, as in CZML, is that value.
     */
    void setProperties(const Json* properties);
    /** Sets a property that is no field of a sighting. */
    void setData(const std::string& name, std::string text) { m_data[name] = std::move(text); }
    /** Adds the title to the candidates for the id, and sets it as the name unless it is the id. */
    void setTitle(const std::string& title);
    [[nodiscard]] FieldTexts& texts() { return m_texts; }
    [[nodiscard]] const FeatureData& data() const { return m_data; }
    [[nodiscard]] std::size_t line() const { return m_line; }

    /**
     * Adds the feature to the scene if its kind says that it is no iceberg. Returns false for
     * icebergs and features of others.
     */
    bool addToScene(const FileFeature& feature);

    /** Adds a place of the feature with the texts; returns false if it is rejected. */
    bool addPlace(const FieldTexts& texts);
    /**
     * Adds each place as an iceberg; `setPlace` sets it in the texts of a sighting or returns the
     * fault. Calls `added` with each place that is not rejected.
     */
    template <class Places, class SetPlace, class Added>
    void addPlaces(const Places& places, const SetPlace& setPlace, const Added& added)
    {
        if (places.size() > 1)
            note(IssueId::SeveralPlaces);
        for (std::size_t i = 0; i < places.size(); ++i) {
            FieldTexts texts = m_texts;
            if (std::optional<RejectedRow> fault = setPlace(texts, places[i])) {
                reject(std::move(*fault));
            } else if (addPlace(texts)) {
                m_table.sightings.back().part = static_cast<std::uint32_t>(i) + 1;
                added(places[i]);
            }
        }
    }
    /** Adds a place of a track, which needs a time if `timeNeeded`. */
    void addTrackPlace(const FieldTexts& texts, std::size_t line, bool timeNeeded);
    /** Marks the places added since there were `first` sightings as one track. */
    void endTrack(std::size_t first) { m_tracks.give(m_table, first); }

    void reject(IssueId fault, const std::string& detail = {});
    void reject(RejectedRow row);
    /** Notes something about the feature. */
    void note(IssueId what);
    /** Notes the geometries that are not used. */
    void noteUnused(const GeometryKinds& kinds);

    [[nodiscard]] SightingTable& table() { return m_table; }
    [[nodiscard]] ReadBudget& budget() { return m_source.budget; }
    /** Returns the sightings and the scene; call it once. */
    [[nodiscard]] SightingTable take();

private:
    /** Returns the row with drift, appearance and change of drift of the data, if it has them. */
    std::variant<Sighting, RejectedRow> withData(std::variant<Sighting, RejectedRow> row);

    const ImportText& m_source;
    ColumnNames m_names;
    SightingTable m_table;
    TrackIds m_tracks;
    bool m_isOwn = false;
    std::size_t m_line = 0;
    std::string m_title;
    FieldTexts m_texts;
    FeatureData m_data;
};

/** Returns the place of two texts, or nullopt if they are not one. */
[[nodiscard]] std::optional<LatLon> placeOf(std::string_view latitude, std::string_view longitude);

} // namespace berg
