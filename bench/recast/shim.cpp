// A C interface over Recast: the walkable cells of convex solids, with the component of each, and the area of the polygons.
// Recast's frame is x, height, y. Lengths are centimetres.
#include <Recast.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <ctime>
#include <vector>

namespace {

struct Cells {
    std::vector<int> column, row, height, component;
    double polygons_cm2 = 0, voxels_s = 0, whole_s = 0;
    int components = 0;
};

double seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

// The triangles of one convex body in a field of its own, then one span a column from its lowest to its highest.
void add_solid(rcContext& context, rcHeightfield& field, const float* vertices, int first, int last, float flat, int climb) {
    float low[3] = {1e30f, 1e30f, 1e30f}, high[3] = {-1e30f, -1e30f, -1e30f};
    for (int corner = 3 * first; corner < 3 * last; corner++) {
        rcVmin(low, vertices + 3 * corner);
        rcVmax(high, vertices + 3 * corner);
    }
    int x0 = std::max(0, int(std::floor((low[0] - field.bmin[0]) / field.cs)) - 1);
    int x1 = std::min(field.width - 1, int(std::floor((high[0] - field.bmin[0]) / field.cs)) + 1);
    int z0 = std::max(0, int(std::floor((low[2] - field.bmin[2]) / field.cs)) - 1);
    int z1 = std::min(field.height - 1, int(std::floor((high[2] - field.bmin[2]) / field.cs)) + 1);
    if (x0 > x1 || z0 > z1) return;
    float from[3] = {field.bmin[0] + x0 * field.cs, field.bmin[1], field.bmin[2] + z0 * field.cs};
    float to[3] = {field.bmin[0] + (x1 + 1) * field.cs, field.bmax[1], field.bmin[2] + (z1 + 1) * field.cs};
    rcHeightfield* own = rcAllocHeightfield();
    rcCreateHeightfield(&context, *own, x1 - x0 + 1, z1 - z0 + 1, from, to, field.cs, field.ch);
    for (int triangle = first; triangle < last; triangle++) {
        const float *a = vertices + 9 * triangle, *b = a + 3, *c = a + 6;
        float one[3], two[3], normal[3];
        rcVsub(one, b, a);
        rcVsub(two, c, a);
        rcVcross(normal, one, two);
        float length = std::sqrt(rcVdot(normal, normal));
        bool walkable = length > 0 && normal[1] / length > flat;
        rcRasterizeTriangle(&context, a, b, c, walkable ? RC_WALKABLE_AREA : RC_NULL_AREA, *own, climb);
    }
    for (int z = 0; z < own->height; z++)
        for (int x = 0; x < own->width; x++) {
            rcSpan* span = own->spans[x + z * own->width];
            if (!span) continue;
            unsigned short bottom = span->smin;
            while (span->next) span = span->next;
            rcAddSpan(&context, field, x0 + x, z0 + z, bottom, (unsigned short)span->smax, (unsigned char)span->area, climb);
        }
    rcFreeHeightField(own);
}

void components_of(const rcCompactHeightfield& field, Cells& made) {
    std::vector<int> component(field.spanCount, -1), stack;
    for (int y = 0; y < field.height; y++)
        for (int x = 0; x < field.width; x++) {
            const rcCompactCell& cell = field.cells[x + y * field.width];
            for (unsigned i = cell.index; i < cell.index + cell.count; i++) {
                if (field.spans[i].reg == 0 || component[i] >= 0) continue;
                component[i] = made.components;
                stack = {x, y, int(i)};
                while (!stack.empty()) {
                    int at = stack.back(), ay, ax;
                    stack.pop_back(), ay = stack.back(), stack.pop_back(), ax = stack.back(), stack.pop_back();
                    for (int side = 0; side < 4; side++) {
                        int link = rcGetCon(field.spans[at], side);
                        if (link == RC_NOT_CONNECTED) continue;
                        int bx = ax + rcGetDirOffsetX(side), by = ay + rcGetDirOffsetY(side);
                        int other = int(field.cells[bx + by * field.width].index) + link;
                        if (field.spans[other].reg == 0 || component[other] >= 0) continue;
                        component[other] = made.components;
                        stack.insert(stack.end(), {bx, by, other});
                    }
                }
                made.components++;
            }
        }
    for (int y = 0; y < field.height; y++)
        for (int x = 0; x < field.width; x++) {
            const rcCompactCell& cell = field.cells[x + y * field.width];
            for (unsigned i = cell.index; i < cell.index + cell.count; i++)
                if (component[i] >= 0) {
                    made.column.push_back(x), made.row.push_back(y);
                    made.height.push_back(field.spans[i].y), made.component.push_back(component[i]);
                }
        }
}

double area_of(const rcPolyMesh& mesh) {
    double twice = 0;
    for (int polygon = 0; polygon < mesh.npolys; polygon++) {
        const unsigned short* corners = mesh.polys + 2 * mesh.nvp * polygon;
        int count = 0;
        while (count < mesh.nvp && corners[count] != RC_MESH_NULL_IDX) count++;
        double own = 0;
        for (int k = 0; k < count; k++) {
            const unsigned short *a = mesh.verts + 3 * corners[k], *b = mesh.verts + 3 * corners[(k + 1) % count];
            own += double(a[0]) * b[2] - double(b[0]) * a[2];
        }
        twice += std::fabs(own);
    }
    return twice / 2 * mesh.cs * mesh.cs;
}

}  // namespace

extern "C" {

// triangles: 9 floats each, those of a body in a row; first: where each body's begin, and their number.
Cells* recast_build(const float* triangles, const int* first, int bodies, const float* low, int columns, int rows, float top,
                    float cell, float step, float radius, float height, float climb, float slope, float region_side,
                    float error) {
    rcContext context(false);
    Cells* made = new Cells;
    double begun = seconds();
    float high[3] = {low[0] + columns * cell, top, low[2] + rows * cell};
    int climb_steps = int(std::floor(climb / step + 1e-4f)), height_steps = int(std::ceil(height / step - 1e-4f));
    int radius_cells = int(std::ceil(radius / cell - 1e-4f)), least = int(region_side / cell * (region_side / cell));
    rcHeightfield* solid = rcAllocHeightfield();
    rcCreateHeightfield(&context, *solid, columns, rows, low, high, cell, step);
    for (int body = 0; body < bodies; body++)
        add_solid(context, *solid, triangles, first[body], first[body + 1], std::cos(slope / 180 * float(M_PI)), climb_steps);
    rcFilterLowHangingWalkableObstacles(&context, climb_steps, *solid);
    rcFilterLedgeSpans(&context, height_steps, climb_steps, *solid);
    rcFilterWalkableLowHeightSpans(&context, height_steps, *solid);
    rcCompactHeightfield* field = rcAllocCompactHeightfield();
    rcBuildCompactHeightfield(&context, height_steps, climb_steps, *solid, *field);
    rcFreeHeightField(solid);
    rcErodeWalkableArea(&context, radius_cells, *field);
    rcBuildDistanceField(&context, *field);
    rcBuildRegions(&context, *field, 0, least, 0);
    made->voxels_s = seconds() - begun;
    rcContourSet* contours = rcAllocContourSet();
    rcBuildContours(&context, *field, error, 0, *contours);
    rcPolyMesh* mesh = rcAllocPolyMesh();
    if (contours->nconts && rcBuildPolyMesh(&context, *contours, 6, *mesh)) made->polygons_cm2 = area_of(*mesh);
    made->whole_s = seconds() - begun;
    components_of(*field, *made);
    rcFreePolyMesh(mesh);
    rcFreeContourSet(contours);
    rcFreeCompactHeightfield(field);
    return made;
}
int recast_count(const Cells* made) { return int(made->column.size()); }
void recast_read(const Cells* made, int* column, int* row, int* height, int* component, double* told) {
    size_t bytes = made->column.size() * sizeof(int);
    std::memcpy(column, made->column.data(), bytes);
    std::memcpy(row, made->row.data(), bytes);
    std::memcpy(height, made->height.data(), bytes);
    std::memcpy(component, made->component.data(), bytes);
    told[0] = made->polygons_cm2, told[1] = made->voxels_s, told[2] = made->whole_s;
}
void recast_free(Cells* made) { delete made; }
}
