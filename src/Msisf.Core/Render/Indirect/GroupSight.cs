namespace Msisf.Core.Render.Indirect;

/// <summary>What the points of a group see of the points of the ground. Keeps buffers, so each thread needs its own object.</summary>
/// <param name="tree">The ground.</param>
/// <param name="lights">The points of the ground.</param>
internal sealed class GroupSight(GroundTree tree, GroundLights lights)
{
    private readonly GroundFan _fan = new();

    /// <summary>The group; set before <see cref="Begin"/>.</summary>
    public Receivers Group { get; } = new();

    /// <summary>Prepares the group that was set.</summary>
    public void Begin()
    {
        Group.Close();
        tree.Start(_fan, Group);
    }

    /// <summary>Whether light from a direction falls on the outside of a point's facet, and of the plane that shades it.</summary>
    public bool Faces(int receiver, Vector3D direction) =>
        Vector3D.Dot(Group.Facets[receiver], direction) > 0.0 && Vector3D.Dot(Group.Normals[receiver], direction) > 0.0;

    /// <summary>Which points of the group face a light from at least their reach away; as bits.</summary>
    public ulong Facing(int light)
    {
        ulong facing = 0;
        for (int receiver = 0; receiver < Group.Count; receiver++)
        {
            Vector3D away = lights.Points[light] - Group.Points[receiver];
            bool isFacing = Vector3D.Dot(lights.Normals[light], away) < 0.0 && Faces(receiver, away)
                && away.LengthSquared >= Group.Reaches[receiver] * Group.Reaches[receiver];
            facing |= isFacing ? 1UL << receiver : 0;
        }

        return facing;
    }

    /// <summary>Which of the points that face a light see it, as bits.</summary>
    public ulong Seeing(int light, ulong facing) => facing == 0 ? 0 : tree.Reach(_fan, lights.Points[light], facing, Group.Count);
}
