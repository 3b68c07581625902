using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Tiles;

namespace Msisf.Core.Tests.Support;

/// <summary>The triangles of some meshes, whatever they belong to, and plain rays against them.</summary>
internal sealed class MeshSoup
{
    private readonly List<(Vector3D Centre, double Radius, Vector3D[] Corners)> _meshes = [];

    public MeshSoup(IReadOnlyList<TileMesh> meshes)
    {
        foreach (TileMesh mesh in meshes)
        {
            Vector3D centre = mesh.Origin.PositionBodyFixed;
            Vector3D[] vertices = [.. Enumerable.Range(0, mesh.VertexCount).Select(vertex => mesh.Vertex(vertex).PositionBodyFixed)];
            _meshes.Add((centre, vertices.Max(vertex => (vertex - centre).Length), [.. mesh.Faces.Select(vertex => vertices[vertex])]));
        }
    }

    /// <summary>Whether a ray meets any triangle, from either side.</summary>
    public bool IsHit(Ray ray)
    {
        foreach ((Vector3D centre, double radius, Vector3D[] corners) in _meshes)
        {
            if (Vector3D.Cross(centre - ray.Origin, ray.Direction).Length > radius * ray.Direction.Length)
            {
                continue;
            }

            for (int corner = 0; corner < corners.Length; corner += 3)
            {
                if (Meets(ray, corners[corner], corners[corner + 1], corners[corner + 2]))
                {
                    return true;
                }
            }
        }

        return false;
    }

    /// <summary>The line passes all three edges on the same side.</summary>
    private static bool Meets(Ray ray, Vector3D a, Vector3D b, Vector3D c)
    {
        Vector3D toA = a - ray.Origin;
        Vector3D toB = b - ray.Origin;
        Vector3D toC = c - ray.Origin;
        double ab = Vector3D.Dot(ray.Direction, Vector3D.Cross(toA, toB));
        double bc = Vector3D.Dot(ray.Direction, Vector3D.Cross(toB, toC));
        double ca = Vector3D.Dot(ray.Direction, Vector3D.Cross(toC, toA));
        if (!((ab >= 0.0 && bc >= 0.0 && ca >= 0.0) || (ab <= 0.0 && bc <= 0.0 && ca <= 0.0)))
        {
            return false;
        }

        // The plane lies before the ray's origin.
        Vector3D normal = Vector3D.Cross(b - a, c - a);
        return Vector3D.Dot(normal, toA) * Vector3D.Dot(normal, ray.Direction) > 0.0;
    }
}
