#include "scenarios/report/video_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/opt.h>
#include <libswscale/swscale.h>
}

#include "models/error.h"

namespace touchdown::report {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxSide_px = 4096;
/// In any 10 s, the encoder writes at most 7.41 Mbit at this rate plus 0.37 Mbit from the buffer, together 972,500
/// bytes. The container adds about 20 bytes per frame.
constexpr std::int64_t kMaxBitRate_bps = 741'000;
constexpr int kBufferBits = 370'000;

struct Deleter {
  void operator()(AVCodecContext* context) const { avcodec_free_context(&context); }
  void operator()(AVFrame* frame) const { av_frame_free(&frame); }
  void operator()(AVPacket* packet) const { av_packet_free(&packet); }
  void operator()(SwsContext* converter) const { sws_freeContext(converter); }
  void operator()(AVFormatContext* container) const {
    if (container->pb != nullptr) avio_closep(&container->pb);
    avformat_free_context(container);
  }
};
template <typename T>
using Owned = std::unique_ptr<T, Deleter>;

/// Takes ownership of an object that a library function allocated. Throws std::bad_alloc for null.
template <typename T>
Owned<T> Own(T* allocated) {
  if (allocated == nullptr) throw std::bad_alloc();
  return Owned<T>(allocated);
}

}  // namespace

cv::Size VideoSize(const cv::Size& frame, const cv::Size& max_size) {
  const double scale = std::min(
      {1.0, static_cast<double>(max_size.width) / frame.width, static_cast<double>(max_size.height) / frame.height});
  const auto even = [scale](int px) { return std::max(2, 2 * static_cast<int>(std::lround(0.5 * scale * px))); };
  return {std::min(even(frame.width), max_size.width / 2 * 2), std::min(even(frame.height), max_size.height / 2 * 2)};
}

struct VideoWriter::Impl {
  Impl(const fs::path& output_file, const cv::Size& frame_size, const FrameRate& rate)
      : file(output_file), size(frame_size), frame_period{rate.seconds, rate.frames} {
    av_log_set_level(AV_LOG_QUIET);  // Errors are thrown.
  }

  void Open() {
    OpenEncoder();
    OpenFile();
    yuv = Own(av_frame_alloc());
    yuv->format = encoder->pix_fmt;
    yuv->width = size.width;
    yuv->height = size.height;
    Check(av_frame_get_buffer(yuv.get(), 0));
    packet = Own(av_packet_alloc());
    converter = Own(sws_getContext(size.width, size.height, AV_PIX_FMT_BGR24, size.width, size.height, encoder->pix_fmt,
                                   SWS_AREA, nullptr, nullptr, nullptr));
  }

  ~Impl() {
    if (finished || container == nullptr) return;
    container.reset();
    std::error_code ignored;
    if (fs::is_regular_file(file, ignored)) fs::remove(file, ignored);
  }

  [[noreturn]] void Fail(std::string_view why) const {
    throw InputError(fmt::format("video {}: {}", file.filename().string(), why));
  }

  /// Throws InputError for a negative return value of a library function; returns the value otherwise.
  int Check(int code) const {
    if (code >= 0) return code;
    std::array<char, AV_ERROR_MAX_STRING_SIZE> why{};
    av_strerror(code, why.data(), why.size());
    Fail(why.data());
  }

  void OpenEncoder() {
    const AVCodec* const codec = avcodec_find_encoder_by_name("libx264");
    if (codec == nullptr) Fail("the installed libavcodec cannot encode H.264 (libx264)");
    encoder = Own(avcodec_alloc_context3(codec));
    encoder->width = size.width;
    encoder->height = size.height;
    encoder->pix_fmt = AV_PIX_FMT_YUV420P;
    encoder->color_range = AVCOL_RANGE_MPEG;
    encoder->colorspace = AVCOL_SPC_SMPTE170M;
    encoder->color_primaries = AVCOL_PRI_SMPTE170M;
    encoder->color_trc = AVCOL_TRC_SMPTE170M;
    encoder->time_base = frame_period;
    encoder->framerate = av_inv_q(frame_period);
    encoder->gop_size = std::max(1, frame_period.den / frame_period.num);
    encoder->thread_count = 1;
    encoder->rc_max_rate = kMaxBitRate_bps;
    encoder->rc_buffer_size = kBufferBits;
    encoder->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
    // The preset superfast disables mbtree and lookahead, which the rate control needs for sharp frames within the bit
    // rate bound. With both enabled it is nearly as fast as superfast and as good as veryfast.
    Check(av_opt_set(encoder->priv_data, "preset", "superfast", 0));
    Check(av_opt_set(encoder->priv_data, "x264-params", "mbtree=1:rc-lookahead=12", 0));
    Check(av_opt_set(encoder->priv_data, "crf", "24", 0));
    Check(avcodec_open2(encoder.get(), codec, nullptr));
  }

  void OpenFile() {
    const std::string url = "file:" + file.string();
    AVFormatContext* allocated = nullptr;
    Check(avformat_alloc_output_context2(&allocated, nullptr, "mp4", url.c_str()));
    Owned<AVFormatContext> opened = Own(allocated);
    stream = avformat_new_stream(opened.get(), nullptr);
    if (stream == nullptr) throw std::bad_alloc();
    stream->time_base = encoder->time_base;
    stream->avg_frame_rate = encoder->framerate;
    Check(avcodec_parameters_from_context(stream->codecpar, encoder.get()));
    Check(avio_open(&opened->pb, url.c_str(), AVIO_FLAG_WRITE));
    container = std::move(opened);
    AVDictionary* header_options = nullptr;
    av_dict_set(&header_options, "movflags", "+faststart", 0);
    const int code = avformat_write_header(container.get(), &header_options);
    av_dict_free(&header_options);
    Check(code);
  }

  /// Encodes a frame and writes the available packets. Null flushes the encoder.
  void Encode(const AVFrame* frame) {
    Check(avcodec_send_frame(encoder.get(), frame));
    for (;;) {
      const int code = avcodec_receive_packet(encoder.get(), packet.get());
      if (code == AVERROR(EAGAIN) || code == AVERROR_EOF) return;
      Check(code);
      packet->duration = 1;
      packet->stream_index = stream->index;
      av_packet_rescale_ts(packet.get(), encoder->time_base, stream->time_base);
      Check(av_interleaved_write_frame(container.get(), packet.get()));
      Check(container->pb->error);
    }
  }

  void Write(const cv::Mat3b& frame) {
    if (frame.size() != size) throw std::logic_error("frame size differs from the video size");
    Check(av_frame_make_writable(yuv.get()));
    const std::array<const std::uint8_t*, 1> rows = {frame.data};
    const std::array<int, 1> strides = {static_cast<int>(frame.step)};
    sws_scale(converter.get(), rows.data(), strides.data(), 0, size.height, yuv->data, yuv->linesize);
    yuv->pts = count;
    Encode(yuv.get());
    ++count;
  }

  void Finish() {
    Encode(nullptr);
    Check(av_write_trailer(container.get()));
    Check(container->pb->error);
    Check(avio_closep(&container->pb));
    finished = true;
  }

  fs::path file;
  cv::Size size;
  AVRational frame_period;
  Owned<AVCodecContext> encoder;
  Owned<AVFormatContext> container;
  AVStream* stream = nullptr;
  Owned<AVFrame> yuv;
  Owned<AVPacket> packet;
  Owned<SwsContext> converter;
  std::int64_t count = 0;
  bool finished = false;
};

VideoWriter::VideoWriter(const fs::path& file, const cv::Size& size, const FrameRate& rate) {
  const auto fits = [](int px) { return px >= 2 && px <= kMaxSide_px && px % 2 == 0; };
  if (!fits(size.width) || !fits(size.height)) {
    throw std::invalid_argument(
        fmt::format("video size is {} x {}; both must be even and 2 to {}", size.width, size.height, kMaxSide_px));
  }
  if (rate.frames < 1 || rate.seconds < 1) {
    throw std::invalid_argument(
        fmt::format("video frame rate is {}/{}; both must be positive", rate.frames, rate.seconds));
  }
  impl_ = std::make_unique<Impl>(file, size, rate);
  impl_->Open();
}

VideoWriter::~VideoWriter() = default;

void VideoWriter::Write(const cv::Mat3b& frame) { impl_->Write(frame); }

std::int64_t VideoWriter::count() const { return impl_->count; }

void VideoWriter::Finish() { impl_->Finish(); }

}  // namespace touchdown::report
