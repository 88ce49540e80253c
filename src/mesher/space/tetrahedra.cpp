#include "mesher/space/tetrahedra.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_domain_with_polyline_features_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/perturb_mesh_3.h>

#include <fmt/format.h>

#include <limits>
#include <map>

#include "mesher/space/featureLines.hpp"

namespace pfem {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;

Vec<3> toVec(const Point& p) { return {p.x(), p.y(), p.z()}; }
Point toPoint(const Vec<3>& x) { return {x[0], x[1], x[2]}; }

/// SpaceDomain as CGAL asks for it (concept MeshDomain_3).
class Bodies {
public:
    using R = Kernel;
    using FT = Kernel::FT;
    using Point_3 = Point;
    using Segment_3 = Kernel::Segment_3;
    using Ray_3 = Kernel::Ray_3;
    using Line_3 = Kernel::Line_3;
    using Vector_3 = Kernel::Vector_3;
    using Sphere_3 = Kernel::Sphere_3;
    using Iso_cuboid_3 = Kernel::Iso_cuboid_3;
    using Has_features = CGAL::Tag_false;
    using Subdomain_index = int;
    using Subdomain = boost::optional<Subdomain_index>;
    using Surface_patch_index = std::pair<int, int>;
    using Surface_patch = boost::optional<Surface_patch_index>;
    using Index = boost::variant<Subdomain_index, Surface_patch_index>;
    using Intersection = std::tuple<Point_3, Index, int>;

    explicit Bodies(const SpaceDomain* domain) : domain_(domain), reach_(2 * (domain->high() - domain->low()).norm()) {}

    CGAL::Bbox_3 bbox() const {
        const auto &a = domain_->low(), &b = domain_->high();
        return {a[0], a[1], a[2], b[0], b[1], b[2]};
    }

    /// Points on surfaces: on all, or on those without a sharp edge, which no line leads to.
    std::vector<std::pair<Point_3, Index>> points(bool all) const {
        constexpr int wanted = 12;  // of a surface
        std::vector<std::pair<Point_3, Index>> found;
        for (const auto& s : domain_->surfaces()) {
            if (!all && !sharpEdges(s).empty()) continue;
            for (int k = 0; k < s.size(); k += std::max(1, s.size() / wanted)) {
                const auto& [a, b, c] = s.triangles[k];
                const Vec<3> centre = (s.x[a] + s.x[b] + s.x[c]) / 3, n = (s.x[b] - s.x[a]).cross(s.x[c] - s.x[a]);
                const Vec<3> step = 1e-3 * std::sqrt(n.norm()) * n.normalized();
                if (const auto at = domain_->crossing(centre - step, centre + step))
                    found.emplace_back(toPoint(at->x), Index(at->labels));
            }
        }
        return found;
    }
    // NOLINTBEGIN(readability-identifier-naming): names that CGAL asks for
    struct Construct_initial_points {
        const Bodies& bodies;
        template <class Out>
        Out operator()(Out out, int = 0) const {
            for (const auto& point : bodies.points(true)) *out++ = point;
            return out;
        }
    };
    Construct_initial_points construct_initial_points_object() const { return {*this}; }

    struct Is_in_domain {
        const Bodies& bodies;
        Subdomain operator()(const Point& p) const {
            const int label = bodies.domain_->label(toVec(p));
            return label == 0 ? Subdomain() : Subdomain(label);
        }
    };
    Is_in_domain is_in_domain_object() const { return {*this}; }

    struct Do_intersect_surface {
        const Bodies& bodies;
        template <class Query>
        Surface_patch operator()(const Query& q) const {
            const auto found = bodies.crossing(q);
            return found ? Surface_patch(found->labels) : Surface_patch();
        }
    };
    Do_intersect_surface do_intersect_surface_object() const { return {*this}; }

    struct Construct_intersection {
        const Bodies& bodies;
        template <class Query>
        Intersection operator()(const Query& q) const {
            const auto found = bodies.crossing(q);
            return found ? Intersection(toPoint(found->x), Index(found->labels), 2) : Intersection();
        }
    };
    Construct_intersection construct_intersection_object() const { return {*this}; }

    Index index_from_surface_patch_index(const Surface_patch_index& i) const { return i; }
    Index index_from_subdomain_index(const Subdomain_index& i) const { return i; }
    Surface_patch_index surface_patch_index(const Index& i) const { return boost::get<Surface_patch_index>(i); }
    Subdomain_index subdomain_index(const Index& i) const { return boost::get<Subdomain_index>(i); }
    // NOLINTEND(readability-identifier-naming)

private:
    std::optional<SpaceDomain::Crossing> crossing(const Segment_3& s) const {
        return domain_->crossing(toVec(s.source()), toVec(s.target()));
    }
    std::optional<SpaceDomain::Crossing> crossing(const Ray_3& r) const {
        const Vec<3> a = toVec(r.source()), d = toVec(r.second_point()) - a;
        return domain_->crossing(a, a + (reach_ + (a - domain_->low()).norm()) * d.normalized());
    }
    std::optional<SpaceDomain::Crossing> crossing(const Line_3& l) const {
        const Vec<3> a = toVec(l.point(0)), d = (toVec(l.point(1)) - a).normalized();
        const double length = reach_ + (a - domain_->low()).norm();
        return domain_->crossing(a - length * d, a + length * d);
    }

    const SpaceDomain* domain_;
    double reach_;
};

using Domain = CGAL::Mesh_domain_with_polyline_features_3<Bodies>;
using Triangulation = CGAL::Mesh_triangulation_3<Domain>::type;
using Complex = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation, Domain::Corner_index, Domain::Curve_index>;
using Criteria = CGAL::Mesh_criteria_3<Triangulation>;

/// The wanted length times a factor, as CGAL asks for it.
struct Field {
    using FT = double;
    using Point_3 = Point;
    using Index = Domain::Index;
    const SizeAt* size;
    double factor;
    double operator()(const Point& p, int dimension, const Index& index) const {
        std::pair<int, int> labels{0, 0};
        if (dimension == 3)
            if (const int* label = boost::get<int>(&index)) labels = {*label, *label};
        if (dimension == 2)
            if (const auto* patch = boost::get<std::pair<int, int>>(&index)) labels = *patch;
        return factor * (*size)(toVec(p), labels);
    }
};

std::vector<std::vector<Point>> toPolylines(const std::vector<Points<3>>& lines) {
    std::vector<std::vector<Point>> result;
    for (const auto& line : lines) {
        result.emplace_back();
        for (const auto& x : line) result.back().push_back(toPoint(x));
    }
    return result;
}

Tetrahedra taken(const Complex& complex) {
    Tetrahedra mesh;
    std::map<Complex::Vertex_handle, int> number;
    for (auto c = complex.cells_in_complex_begin(); c != complex.cells_in_complex_end(); ++c) {
        Simplex<3> cell;
        for (int k = 0; k < 4; ++k) {
            const auto [at, isNew] = number.emplace(c->vertex(k), static_cast<int>(mesh.x.size()));
            if (isNew)
                mesh.x.push_back(
                    toVec(complex.triangulation().geom_traits().construct_point_3_object()(c->vertex(k)->point())));
            cell[k] = at->second;
        }
        mesh.cells.push_back(cell);
        mesh.label.push_back(complex.subdomain_index(c));
    }
    return mesh;
}

}  // namespace

namespace {

/// The place of the shortest edge [m], for an error message.
Vec<3> finestPlace(const Complex& complex) {
    double least = std::numeric_limits<double>::max();
    Vec<3> place = Vec<3>::Zero();
    const auto& all = complex.triangulation();
    for (auto e = all.finite_edges_begin(); e != all.finite_edges_end(); ++e) {
        const auto s = all.segment(*e);
        if (s.squared_length() >= least) continue;
        least = s.squared_length();
        place = toVec(s.source());
    }
    return place;
}

/// Points far outside: without them faces in an oblique plane have flat cells beside them, whose spheres have centres
/// at 1e15 m or anywhere.
void addFarPoints(const SpaceDomain& domain, Complex& complex) {
    const Vec<3> centre = 0.5 * (domain.low() + domain.high());
    const double far = 1.5 * (domain.high() - domain.low()).norm();
    for (int i = -1; i <= 1; ++i)
        for (int j = -1; j <= 1; ++j)
            for (int k = -1; k <= 1; ++k)
                if (i != 0 || j != 0 || k != 0)
                    complex.add_far_point(complex.triangulation().geom_traits().construct_weighted_point_3_object()(
                        toPoint(centre + far * Vec<3>(i, j, k))));
}

Tetrahedra fill(const SpaceDomain& domain, const std::vector<Points<3>>& lines, const SizeAt& size, double mostNodes) {
    using namespace CGAL::parameters;
    CGAL::get_default_random() = CGAL::Random(0);
    Domain bodies{&domain};
    const auto polylines = toPolylines(lines);
    bodies.add_features(polylines.begin(), polylines.end());
    const Field ofEdges{&size, 1.0}, ofFacets{&size, 0.73}, ofCells{&size, 0.73}, ofDistance{&size, 0.1};
    const Criteria criteria(edge_size = ofEdges, facet_angle = 25, facet_size = ofFacets, facet_distance = ofDistance,
                            cell_radius_edge_ratio = 2, cell_size = ofCells);
    CGAL::Mesh_error_code failure = CGAL::CGAL_MESH_3_NO_ERROR;
    const auto limits = mesh_3_options(maximal_number_of_vertices = static_cast<std::size_t>(mostNodes),
                                       pointer_to_error_code = &failure);
    Complex complex;
    CGAL::Mesh_3::internal::C3t3_initializer<Complex, Domain, Criteria, true>()(complex, bodies, criteria, true,
                                                                                limits);
    addFarPoints(domain, complex);
    for (const auto& [point, index] : bodies.points(false)) {
        const auto at = complex.triangulation().geom_traits().construct_weighted_point_3_object()(point);
        const auto vertex = complex.triangulation().insert(at);
        if (vertex == Complex::Vertex_handle()) continue;  // within the protection of a line
        complex.set_dimension(vertex, 2);
        complex.set_index(vertex, index);
    }
    CGAL::refine_mesh_3(complex, bodies, criteria, no_perturb(), no_exude(), no_lloyd(), no_odt(), no_reset_c3t3(),
                        limits);
    if (failure != CGAL::CGAL_MESH_3_NO_ERROR) {
        const Vec<3> x = finestPlace(complex);
        throw UserError(
            fmt::format("More than {:g} nodes are needed: surfaces have details that are much finer than "
                        "meshSize, or gaps or acute edges, near ({:g} {:g} {:g})",
                        mostNodes, x[0], x[1], x[2]));
    }
    CGAL::perturb_mesh_3(complex, bodies, sliver_bound = 12);
    return taken(complex);
}

/// CGAL speaks on stderr, unless it is told not to.
class Quiet {
public:
    Quiet() : error_(CGAL::set_error_handler(&ignore)), warning_(CGAL::set_warning_handler(&ignore)) {}
    ~Quiet() {
        CGAL::set_error_handler(error_);
        CGAL::set_warning_handler(warning_);
    }
    Quiet(const Quiet&) = delete;
    Quiet& operator=(const Quiet&) = delete;

private:
    static void ignore(const char*, const char*, const char*, int, const char*) {}
    CGAL::Failure_function error_, warning_;
};

}  // namespace

Tetrahedra fillBodies(const SpaceDomain& domain, const std::vector<Points<3>>& lines, const SizeAt& size,
                      double mostNodes) {
    const Quiet quiet;
    try {
        return fill(domain, lines, size, mostNodes);
    } catch (const CGAL::Failure_exception& error) {
        throw UserError(
            fmt::format("The bodies cannot be filled at this meshSize: surfaces nearly touch, or meet at acute "
                        "angles (CGAL: {})",
                        error.message()));
    }
}

}  // namespace pfem
