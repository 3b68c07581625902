namespace Msisf.Core.Numerics;

/// <summary>A box with edges in any direction.</summary>
/// <param name="Centre">m, body-fixed.</param>
/// <param name="HalfX">m, MOON_ME: from the centre to the middle of a side.</param>
/// <param name="HalfY">The same, at a right angle to <paramref name="HalfX"/>.</param>
/// <param name="HalfZ">The same, at a right angle to both.</param>
internal readonly record struct OrientedBox(Vector3D Centre, Vector3D HalfX, Vector3D HalfY, Vector3D HalfZ)
{
    /// <summary>How far the box extends from its centre along a direction; m for a direction of length 1.</summary>
    public double ReachAlong(Vector3D direction) =>
        Math.Abs(Vector3D.Dot(direction, HalfX)) + Math.Abs(Vector3D.Dot(direction, HalfY)) + Math.Abs(Vector3D.Dot(direction, HalfZ));
}
