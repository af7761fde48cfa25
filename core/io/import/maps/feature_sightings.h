#pragma once

// Private to core/io: the step from the features of a map file to sightings, for every format.

#include "core/io/import/fields/feature_scene.h"
#include "core/io/import/fields/import_fields.h"
#include "core/io/import/fields/import_source.h"

#include <string>
#include <utility>
#include <vector>

namespace berg {

/**
 * Collects the sightings and the scene of a map file, feature by feature. In a Bergwatch export
 * only icebergs and features of no kind become sightings.
 */
class FeatureSightings
{
public:
    /** `place` is the unit of lines in findings, as in `Rejections::place`. */
    explicit FeatureSightings(const ImportText& source, std::string_view place = "line");

    /**
     * Adds a feature to the scene, or as icebergs: its tracks, else its points, else its areas,
     * else the corners of a route. What is not taken is rejected or noted. Returns true if an id is
     * among the properties and the name.
     */
    bool add(const FileFeature& feature);

    // For a reader that finds the fields of a place one by one:

    /** Begins a feature without properties in a Bergwatch export, if `isOwn`, or another file. */
    void begin(std::size_t line, bool isOwn);
    /** Sets a property that may be a field of a sighting. The geometry determines the place. */
    void setProperty(const std::string& name, const std::string& text);
    /** Sets a property that is no field of a sighting. */
    void setData(const std::string& name, std::string text) { m_data[name] = std::move(text); }
    /** Adds the title to the candidates for the id, and sets it as the name unless it is the id. */
    void setTitle(const std::string& title);
    [[nodiscard]] FieldTexts& texts() { return m_texts; }
    [[nodiscard]] std::size_t line() const { return m_line; }

    /**
     * Adds the feature to the scene if its kind says that it is no iceberg. Returns false for
     * icebergs and features of others.
     */
    bool addToScene(const FileFeature& feature);

    /** Adds a place of the feature with the texts; returns false if it is rejected. */
    bool addPlace(const FieldTexts& texts);
    /** Adds a place of a track, which needs a time if `timeNeeded`. */
    void addTrackPlace(const FieldTexts& texts, std::size_t line, bool timeNeeded);
    /** Marks the places added since there were `first` sightings as one track. */
    void endTrack(std::size_t first) { m_tracks.give(m_table, first); }

    void reject(RejectedRow row);

    [[nodiscard]] SightingTable& table() { return m_table; }
    /** Returns the sightings and the scene; call it once. */
    [[nodiscard]] SightingTable take();

private:
    using Shapes = std::vector<FileShape>;

    bool begin(const FileFeature& feature);
    /**
     * Sets the members of an object (may be null). A pair becomes the components of a vector; a
     * value in an object that states its type, as in CZML, is that value.
     */
    void setProperties(const Json* properties);
    void addGeometry(const FileGeometry& geometry);
    void addTracks(const Shapes& shapes);
    void addPoints(const Shapes& shapes);
    void addAreas(const std::vector<AreaRings>& areas, const GeoJsonSystem& system);
    void addRoute(const Shapes& shapes);
    /** Sets the place in the texts, or rejects it and returns false. */
    bool setPlace(FieldTexts& texts, const FilePlace& place);
    void reject(IssueId fault, const std::string& detail = {});
    /** Notes something about the feature. */
    void note(IssueId what);
    /** Rejects places of three whole numbers if another place of the file has decimal commas. */
    void rejectDecimalCommas();
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
    std::vector<std::size_t> m_doubtful; ///< rows whose place may have decimal commas
    bool m_hasDecimalCommas = false;
};

} // namespace berg
