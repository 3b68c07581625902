using Msisf.Adapters.CameraExport;
using Msisf.Core.Numerics;
using Xunit;

namespace Msisf.Adapters.Tests.CameraExport;

public sealed class ScanNodesTests
{
    /// <summary>A quaternion and its opposite are the same turn, but what lies between their components is none.</summary>
    [Fact]
    public void Of_SignsThatJump_SameNodesWithoutJumps()
    {
        (Vector3D Position, UnitQuaternion Turn)[] poses = [.. Enumerable.Range(0, 100).Select(i => (
            new Vector3D(1.8e6 + i, 3.0 * i, 0.0), UnitQuaternion.FromAxisAngle(new Vector3D(1.0, 2.0, 3.0), 0.01 * i)))];
        (Vector3D Position, UnitQuaternion Turn)[] jumping =
        [
            .. poses.Select((pose, i) => i % 3 == 1
                ? (pose.Position, UnitQuaternion.FromComponents(-pose.Turn.X, -pose.Turn.Y, -pose.Turn.Z, -pose.Turn.W))
                : pose),
        ];

        ScanNodes nodes = ScanNodes.Of(jumping, (_, _) => 0.0);

        Assert.Equal(ScanNodes.Of(poses, (_, _) => 0.0).Poses, nodes.Poses);
        Assert.All(nodes.Poses.Zip(nodes.Poses.Skip(1)), pair => Assert.True(
            (pair.First.Turn.X * pair.Second.Turn.X) + (pair.First.Turn.W * pair.Second.Turn.W) > 0.0));
    }

    /// <summary>Nodes of 100 exposures: 3 before, 3 after, and one for as many exposures as the error allows; 25 or more.</summary>
    [Theory]
    [InlineData(0.0, 4.0, 32)]
    [InlineData(1e-4, 1.0, 106)]
    public void Of_Error_DecidesHowMany(double error, double spacing, int count)
    {
        (Vector3D Position, UnitQuaternion Turn)[] poses =
            [.. Enumerable.Range(0, 100).Select(i => (new Vector3D(i, 0.0, 0.0), UnitQuaternion.Identity))];

        ScanNodes nodes = ScanNodes.Of(poses, (_, _) => error);

        Assert.Equal((spacing, count, -3.0 * spacing), (nodes.Spacing, nodes.Poses.Count, nodes.First));
        Assert.All(nodes.Poses.Select((pose, i) => (pose, i)), node => Assert.Equal(
            nodes.First + (node.i * spacing), node.pose.Position.X, 1e-9));
    }
}
