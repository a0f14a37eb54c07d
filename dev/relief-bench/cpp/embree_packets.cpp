// Times Embree 3 on packets of rays over a triangle mesh.
//
// Arguments: a folder, runs, an instruction set as Embree's option `isa` names it or `best`, and the names of
// sets of rays. The folder holds vertices.raw (f32, x y z), triangles.raw (u32, three corners), and for each
// set NAME.rays (f32: origin, direction and length). Prints a line for the scene, `build SECONDS BYTES`, and
// for each set and width of packets `set NAME WIDTH INTERSECT OCCLUDED HITS`: rays a second of the best run,
// and how many rays hit.
//
// Everything runs on one thread, and seconds are those of its processor time.

#include <embree3/rtcore.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string>
#include <vector>

template <typename T> static std::vector<T> read(const std::string &path) {
    std::vector<T> items;
    FILE *file = std::fopen(path.c_str(), "rb");
    if (!file) {
        std::fprintf(stderr, "cannot read %s\n", path.c_str());
        std::exit(1);
    }
    std::fseek(file, 0, SEEK_END);
    items.resize(std::ftell(file) / sizeof(T));
    std::fseek(file, 0, SEEK_SET);
    if (std::fread(items.data(), sizeof(T), items.size(), file) != items.size()) {
        std::exit(1);
    }
    std::fclose(file);
    return items;
}

static double seconds() {
    timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return now.tv_sec + 1e-9 * now.tv_nsec;
}

static long long held;

static bool count_bytes(void *, ssize_t bytes, bool) {
    held += bytes;
    return true;
}

struct Rays {
    size_t count;
    std::vector<float> numbers;
};

template <int N> struct Width;
template <> struct Width<8> {
    using Hit = RTCRayHit8;
    using Ray = RTCRay8;
    static void intersect(const int *valid, RTCScene scene, RTCIntersectContext *context, Hit *rays) {
        rtcIntersect8(valid, scene, context, rays);
    }
    static void occluded(const int *valid, RTCScene scene, RTCIntersectContext *context, Ray *rays) {
        rtcOccluded8(valid, scene, context, rays);
    }
};
template <> struct Width<16> {
    using Hit = RTCRayHit16;
    using Ray = RTCRay16;
    static void intersect(const int *valid, RTCScene scene, RTCIntersectContext *context, Hit *rays) {
        rtcIntersect16(valid, scene, context, rays);
    }
    static void occluded(const int *valid, RTCScene scene, RTCIntersectContext *context, Ray *rays) {
        rtcOccluded16(valid, scene, context, rays);
    }
};

template <int N, typename R> static void fill(R &ray, const float *numbers, size_t count, int *valid) {
    for (size_t k = 0; k < N; ++k) {
        const float *from = numbers + 7 * std::min(k, count - 1);
        valid[k] = k < count ? -1 : 0;
        ray.org_x[k] = from[0];
        ray.org_y[k] = from[1];
        ray.org_z[k] = from[2];
        ray.dir_x[k] = from[3];
        ray.dir_y[k] = from[4];
        ray.dir_z[k] = from[5];
        ray.tnear[k] = 0.0f;
        ray.tfar[k] = from[6];
        ray.time[k] = 0.0f;
        ray.mask[k] = ~0u;
        ray.id[k] = 0;
        ray.flags[k] = 0;
    }
}

// Rays that are made before time is measured: so few that they are in the nearest cache.
static const size_t NEAR = 256;

// How many rays hit, and how long that took.
struct Found {
    size_t hits = 0;
    double taken = 0;
};

// Fills packets of N rays each, traces them while time is measured, and counts those that hit.
template <int N, typename Packet, typename Fill, typename Trace, typename IsHit>
static Found timed(const Rays &rays, Fill fill, Trace trace, IsHit is_hit) {
    alignas(64) Packet packets[NEAR / N];
    alignas(64) int valid[NEAR / N][N];
    Found found;
    for (size_t first = 0; first < rays.count; first += NEAR) {
        size_t count = std::min(NEAR, rays.count - first), used = (count + N - 1) / N;
        for (size_t p = 0; p < used; ++p) {
            fill(packets[p], &rays.numbers[7 * (first + p * N)], count - p * N, valid[p]);
        }
        double start = seconds();
        for (size_t p = 0; p < used; ++p) {
            trace(valid[p], packets[p]);
        }
        found.taken += seconds() - start;
        for (size_t k = 0; k < count; ++k) {
            found.hits += is_hit(packets[k / N], k % N);
        }
    }
    return found;
}

template <int N> static Found intersect(RTCScene scene, RTCIntersectContext *context, const Rays &rays) {
    using Hit = typename Width<N>::Hit;
    auto with_hits = [](Hit &packet, const float *numbers, size_t count, int *valid) {
        fill<N>(packet.ray, numbers, count, valid);
        for (int k = 0; k < N; ++k) {
            packet.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
            packet.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
        }
    };
    auto trace = [&](const int *valid, Hit &packet) {
        Width<N>::intersect(valid, scene, context, &packet);
    };
    auto is_hit = [](const Hit &packet, size_t k) { return packet.hit.geomID[k] != RTC_INVALID_GEOMETRY_ID; };
    return timed<N, Hit>(rays, with_hits, trace, is_hit);
}

template <int N> static Found occluded(RTCScene scene, RTCIntersectContext *context, const Rays &rays) {
    using Ray = typename Width<N>::Ray;
    auto trace = [&](const int *valid, Ray &packet) {
        Width<N>::occluded(valid, scene, context, &packet);
    };
    auto is_hit = [](const Ray &packet, size_t k) { return packet.tfar[k] < 0.0f; };
    return timed<N, Ray>(rays, fill<N, Ray>, trace, is_hit);
}

static void single(RTCRay &ray, const float *from) {
    std::memset(&ray, 0, sizeof ray);
    ray.org_x = from[0];
    ray.org_y = from[1];
    ray.org_z = from[2];
    ray.dir_x = from[3];
    ray.dir_y = from[4];
    ray.dir_z = from[5];
    ray.tfar = from[6];
    ray.mask = ~0u;
}

static Found intersect_each(RTCScene scene, RTCIntersectContext *context, const Rays &rays) {
    auto with_hit = [](RTCRayHit &one, const float *numbers, size_t, int *) {
        single(one.ray, numbers);
        one.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        one.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    };
    auto trace = [&](const int *, RTCRayHit &one) { rtcIntersect1(scene, context, &one); };
    auto is_hit = [](const RTCRayHit &one, size_t) { return one.hit.geomID != RTC_INVALID_GEOMETRY_ID; };
    return timed<1, RTCRayHit>(rays, with_hit, trace, is_hit);
}

static Found occluded_each(RTCScene scene, RTCIntersectContext *context, const Rays &rays) {
    auto fill = [](RTCRay &one, const float *numbers, size_t, int *) { single(one, numbers); };
    auto trace = [&](const int *, RTCRay &one) { rtcOccluded1(scene, context, &one); };
    auto is_hit = [](const RTCRay &one, size_t) { return one.tfar < 0.0f; };
    return timed<1, RTCRay>(rays, fill, trace, is_hit);
}

template <typename F> static double rate(size_t count, int runs, size_t &hits, F trace) {
    double best = 1e30;
    for (int run = 0; run < runs; ++run) {
        Found found = trace();
        hits = found.hits;
        best = std::min(best, found.taken);
    }
    return count / best;
}

int main(int argc, char **argv) {
    if (argc < 4) {
        return 1;
    }
    std::string folder = std::string(argv[1]) + "/", isa = argv[3];
    int runs = std::atoi(argv[2]);
    auto vertices = read<float>(folder + "vertices.raw");
    auto triangles = read<unsigned>(folder + "triangles.raw");
    std::string config = "threads=1,frequency_level=simd512";
    if (isa != "best") {
        config += ",isa=" + isa;
    }
    RTCDevice device = rtcNewDevice(config.c_str());
    if (!device) {
        return 1;
    }
    rtcSetDeviceMemoryMonitorFunction(device, count_bytes, nullptr);
    RTCScene scene = nullptr;
    double best = 1e30;
    for (int run = 0; run < runs; ++run) {
        if (scene) {
            rtcReleaseScene(scene);
        }
        held = 0;
        double start = seconds();
        scene = rtcNewScene(device);
        RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        void *points =
            rtcSetNewGeometryBuffer(
                geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, vertices.size() / 3);
        std::memcpy(points, vertices.data(), vertices.size() * sizeof(float));
        void *corners =
            rtcSetNewGeometryBuffer(
                geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, triangles.size() / 3);
        std::memcpy(corners, triangles.data(), triangles.size() * sizeof(unsigned));
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene);
        best = std::min(best, seconds() - start);
    }
    std::printf("build %g %lld\n", best, held);
    for (int at = 4; at < argc; ++at) {
        std::string name = argv[at];
        Rays rays;
        rays.numbers = read<float>(folder + name + ".rays");
        rays.count = rays.numbers.size() / 7;
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        auto measure = [&](int width, auto intersected, auto occluded) {
            size_t hits = 0, blocked = 0;
            double first = rate(rays.count, runs, hits, [&] { return intersected(scene, &context, rays); });
            double any = rate(rays.count, runs, blocked, [&] { return occluded(scene, &context, rays); });
            std::printf("set %s %d %g %g %zu\n", name.c_str(), width, first, any, hits);
        };
        measure(1, intersect_each, occluded_each);
        measure(8, intersect<8>, occluded<8>);
        measure(16, intersect<16>, occluded<16>);
    }
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
}
