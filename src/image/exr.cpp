// OpenEXR through its C++ library, by streams of ours in memory. The library's thread pool is left
// empty (0 threads): a picture takes milliseconds, and callers have threads of their own.
#include "image/exr.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <exception>
#include <new>
#include <stdexcept>
#include <utility>

#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <sheer/error.h>

namespace sheer {
namespace {

constexpr int kNoThreads = 0;
constexpr std::array<const char*, 4> kChannels = {"R", "G", "B", "A"};

class MemoryOutput final : public Imf::OStream {
public:
    MemoryOutput() : OStream("memory") {}

    void write(const char text[], int count) override
    {
        const auto size = static_cast<std::size_t>(count);
        // The library goes back once, to fill in its table of offsets.
        if (bytes.size() < position_ + size) bytes.resize(position_ + size);
        std::memcpy(bytes.data() + position_, text, size);
        position_ += size;
    }
    std::uint64_t tellp() override { return position_; }
    void seekp(std::uint64_t position) override { position_ = position; }

    std::vector<std::byte> bytes;

private:
    std::size_t position_ = 0;
};

class MemoryInput final : public Imf::IStream {
public:
    explicit MemoryInput(std::span<const std::byte> bytes) : IStream("memory"), bytes_(bytes) {}

    bool read(char to[], int count) override
    {
        const auto size = static_cast<std::size_t>(count);
        if (count < 0 || position_ > bytes_.size() || size > bytes_.size() - position_) {
            throw std::runtime_error("the file is cut short");
        }
        std::memcpy(to, bytes_.data() + position_, size);
        position_ += size;
        return position_ < bytes_.size();
    }
    std::uint64_t tellg() override { return position_; }
    void seekg(std::uint64_t position) override { position_ = position; }

private:
    std::span<const std::byte> bytes_;
    std::size_t position_ = 0;
};

struct Size {
    std::int64_t width, height;
};

Size size_of(const Imath::Box2i& window)
{
    return {std::int64_t{window.max.x} - window.min.x + 1,
            std::int64_t{window.max.y} - window.min.y + 1};
}

// A slice that addresses pixel (x, y) of the file's window as (x - min.x, y - min.y) of the image.
Imf::Slice slice_of(Image& image, std::size_t channel, const Imath::Box2i& window)
{
    constexpr std::size_t kPixel = sizeof(image.pixels[0]);
    const float fill = channel == 3 ? 1.0f : 0.0f;
    return Imf::Slice::Make(Imf::FLOAT, &image.pixels[0][channel], window, kPixel,
                            kPixel * static_cast<std::size_t>(image.width), 1, 1, fill);
}

// The names of the channels for red, green, blue and alpha; throws where the colours are missing.
std::array<const char*, 4> channel_names(const Imf::ChannelList& channels)
{
    const auto has = [&](const char* name) { return channels.findChannel(name) != nullptr; };
    if (std::all_of(kChannels.begin(), kChannels.begin() + 3, has)) return kChannels;
    // With RY and BY beside it, Y is not grey but the luminance of a coloured picture.
    if (!has("Y") || has("RY")) {
        throw std::runtime_error("it has neither channels R, G, B nor Y alone");
    }
    return {"Y", "Y", "Y", "A"};
}

Image read_window(Imf::InputFile& file, const Imath::Box2i& window)
{
    const Size size = size_of(window);
    const std::array<const char*, 4> names = channel_names(file.header().channels());
    const bool grey = names[0] == names[1];
    Image image(static_cast<int>(size.width), static_cast<int>(size.height));
    Imf::FrameBuffer frame;
    // A channel can be read into one place only: grey goes to red and is spread below.
    for (std::size_t c = 0; c < names.size(); ++c) {
        if (!grey || c == 0 || c == 3) frame.insert(names[c], slice_of(image, c, window));
    }
    file.setFrameBuffer(frame);
    file.readPixels(window.min.y, window.max.y);
    if (grey) {
        for (std::array<float, 4>& pixel : image.pixels) pixel[1] = pixel[2] = pixel[0];
    }
    return image;
}

// What `display` shows of the image that fills `data`.
Image crop(const Image& image, const Imath::Box2i& data, const Imath::Box2i& display)
{
    const Size size = size_of(display);
    Image cropped(static_cast<int>(size.width), static_cast<int>(size.height));
    const int left = std::max(data.min.x, display.min.x);
    const int right = std::min(data.max.x, display.max.x);
    for (int y = std::max(data.min.y, display.min.y);
         y <= std::min(data.max.y, display.max.y) && left <= right; ++y) {
        const std::array<float, 4>* from = &image.at(left - data.min.x, y - data.min.y);
        std::copy(from, from + (right - left + 1),
                  &cropped.at(left - display.min.x, y - display.min.y));
    }
    return cropped;
}

void check_size(const Imath::Box2i& window)
{
    const Size size = size_of(window);
    if (size.width < 1 || size.height < 1) throw std::runtime_error("it has no pixels");
    if (size.width > kMaxImageSize || size.height > kMaxImageSize) {
        throw std::runtime_error("larger than " + std::to_string(kMaxImageSize) + " pixels");
    }
}

}  // namespace

std::vector<std::byte> encode_exr(int width, int height, std::span<const ExrChannel> channels)
{
    if (width < 1 || height < 1) throw Error(Fault::work, "OpenEXR: the picture has no pixels");
    try {
        Imf::Header header(width, height);
        header.compression() = Imf::ZIP_COMPRESSION;
        Imf::FrameBuffer frame;
        const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
        for (const ExrChannel& channel : channels) {
            header.channels().insert(channel.name, Imf::Channel(Imf::FLOAT));
            const std::size_t step = channel.step * sizeof(float);
            // Writing only reads from a slice, though its type does not say so.
            frame.insert(
                channel.name,
                Imf::Slice::Make(Imf::FLOAT, const_cast<float*>(channel.first), header.dataWindow(),
                                 step, step * static_cast<std::size_t>(width)));
        }
        MemoryOutput stream;
        // As much as noise takes, so that nothing is ever moved; what is not used costs nothing.
        stream.bytes.reserve(pixels * channels.size() * sizeof(float) * 65 / 64 + 65536);
        {
            Imf::OutputFile file(stream, header, kNoThreads);
            file.setFrameBuffer(frame);
            file.writePixels(height);
        }
        return std::move(stream.bytes);
    } catch (const std::exception& error) {
        throw Error(Fault::work, std::string("OpenEXR: ") + error.what());
    }
}

std::vector<std::byte> encode_exr(const Image& image)
{
    std::array<ExrChannel, 4> channels{};
    for (std::size_t c = 0; c < channels.size(); ++c) {
        channels[c] = {kChannels[c], image.pixels.empty() ? nullptr : &image.pixels[0][c], 4};
    }
    const bool empty = image.pixels.empty();
    return encode_exr(empty ? 0 : image.width, empty ? 0 : image.height, channels);
}

Image decode_exr(std::span<const std::byte> bytes, const std::string& path)
{
    try {
        MemoryInput stream(bytes);
        Imf::InputFile file(stream, kNoThreads);
        const Imath::Box2i data = file.header().dataWindow();
        const Imath::Box2i display = file.header().displayWindow();
        check_size(data);
        check_size(display);
        Image image = read_window(file, data);
        return data == display ? std::move(image) : crop(image, data, display);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        throw Error(Fault::input, path + ": not a readable OpenEXR file: " + error.what());
    }
}

}  // namespace sheer
