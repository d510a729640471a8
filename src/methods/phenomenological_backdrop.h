// What phenomenological transparency does to what is behind: diffusion and refraction, of each
// sample of a tile (shaders/sheer/phenomenological.glsl).
//
// Fragments know neither how rough nor how dense they are: all that are transparent have the
// method's own collimation and index. A triangle's normal is that of its plane of depth. What is
// looked up is the picture of all that is opaque (backdrop_picture.h), pixel by pixel.
#pragma once

#include "methods/backdrop_picture.h"
#include "methods/method.h"

namespace sheer {

// The paper's symbols.
struct PhenomenologicalSettings {
    float collimation;  // 1: what is behind is not blurred
    float eta;          // 1: nor displaced

    bool diffuses() const { return collimation < 1; }
    bool refracts() const { return eta > 1; }
    bool reads_backdrop() const { return diffuses() || refracts(); }
};

PhenomenologicalSettings phenomenological_settings(const ChosenMethod& method);

class PhenomenologicalBackdrop {
public:
    // Of a shape with a picture of the backdrop.
    explicit PhenomenologicalBackdrop(const StoreShape& shape);

    void clear(const TilePlace& place);
    void insert(const FragmentStream& stream);
    void merge(const PhenomenologicalBackdrop& other);
    // Puts what is seen through the fragments in the place of what is behind them.
    void replace(SampleColors& backdrop) const;

    static constexpr int kBytesPerSample = 3 * sizeof(float);

private:
    struct Change {
        float variance = 0, x = 0, y = 0;
    };
    Change change_of(const FragmentStream& stream, const FragmentRun& run, std::size_t i) const;

    const SampleSet& set_;
    const BackdropPicture& picture_;
    PhenomenologicalSettings settings_;
    EyeSpace eye_;
    TilePlace place_;
    std::vector<Change> changes_;  // of each sample
    bool any_ = false;
};

}  // namespace sheer
